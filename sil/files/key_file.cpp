#include "sil/files/key_file.hpp"

#include <fmt/format.h>

#include <string>

#include "hal/software_keys/software_keys.hpp"
#include "sil/files/toml_table.hpp"

namespace sil {
namespace {

constexpr const char* slot_names[rsi::hal::key_slots]{"calibration", "diagnosis", "parameters"};

int digit_of(char letter) {
    if (letter >= '0' && letter <= '9') {
        return letter - '0';
    }
    if (letter >= 'a' && letter <= 'f') {
        return letter - 'a' + 10;
    }
    return letter >= 'A' && letter <= 'F' ? letter - 'A' + 10 : -1;
}

}  // namespace

rsi::hal::Key load_key(const std::filesystem::path& path, rsi::hal::KeySlot slot) {
    const auto place = static_cast<std::size_t>(slot);
    if (path == test_key_name) {
        return rsi::hal::test_keys[place];
    }
    TomlTable table =
        TomlTable::load(path, "name a key file with lines like parameters = \"32 hexadecimal digits\"");
    for (const char* const name : slot_names) {
        table.allow(name);
    }
    table.refuse_unknown_keys();
    const char* const name = slot_names[place];
    const std::string text = table.text(name);
    rsi::hal::Key key{};
    bool good = text.size() == 2U * key.size();
    for (std::size_t byte = 0U; good && byte < key.size(); ++byte) {
        const int high = digit_of(text[2U * byte]);
        const int low = digit_of(text[2U * byte + 1U]);
        good = high >= 0 && low >= 0;
        key[byte] = static_cast<std::uint8_t>(16 * high + low);
    }
    if (!good) {
        table.fail(name, fmt::format("is no key of AES-128: write {} hexadecimal digits", 2U * key.size()));
    }
    return key;
}

}  // namespace sil
