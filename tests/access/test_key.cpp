// test-key calibration|diagnosis SEED: the key for a seed of 16 bytes, both as hexadecimal digits, by the
// test key of XCP or of UDS. For tests on a machine whose Python knows no AES.
#include <charconv>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "hal/software_keys/software_keys.hpp"

int main(int argc, char** argv) {
    rsi::hal::AuthenticationCode seed{};
    const std::string_view slot = (argc == 3) ? argv[1] : "";
    if ((slot != "calibration" && slot != "diagnosis") || std::strlen(argv[2]) != 2U * seed.size()) {
        std::fputs("test-key wants `calibration` or `diagnosis`, and a seed of 32 hexadecimal digits\n",
                   stderr);
        return 2;
    }
    for (std::size_t at = 0U; at < seed.size(); ++at) {
        std::from_chars(argv[2] + 2U * at, argv[2] + 2U * at + 2U, seed[at], 16);
    }
    rsi::hal::SoftwareKeys keys{rsi::hal::test_keys};
    rsi::hal::AuthenticationCode key{};
    const rsi::hal::KeySlot its_slot =
        (slot == "diagnosis") ? rsi::hal::KeySlot::diagnosis : rsi::hal::KeySlot::calibration;
    if (!keys.authenticate(its_slot, seed.data(), seed.size(), key)) {
        return 1;
    }
    for (const std::uint8_t byte : key) {
        std::printf("%02X", byte);
    }
    std::puts("");
    return 0;
}
