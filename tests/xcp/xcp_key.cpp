// xcp-key SEED: the key for a seed of 16 bytes, both as hexadecimal digits, by the test key. For tests on a
// machine whose Python knows no AES.
#include <charconv>
#include <cstdio>
#include <cstring>

#include "hal/software_keys/software_keys.hpp"

int main(int argc, char** argv) {
    hal::AuthenticationCode seed{};
    if (argc != 2 || std::strlen(argv[1]) != 2U * seed.size()) {
        std::fputs("xcp-key wants a seed of 32 hexadecimal digits\n", stderr);
        return 2;
    }
    for (std::size_t at = 0U; at < seed.size(); ++at) {
        std::from_chars(argv[1] + 2U * at, argv[1] + 2U * at + 2U, seed[at], 16);
    }
    hal::SoftwareKeys keys{hal::test_keys};
    hal::AuthenticationCode key{};
    if (!keys.authenticate(hal::KeySlot::calibration, seed.data(), seed.size(), key)) {
        return 1;
    }
    for (const std::uint8_t byte : key) {
        std::printf("%02X", byte);
    }
    std::puts("");
    return 0;
}
