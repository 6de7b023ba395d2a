#include "hal/software_keys/software_keys.hpp"

namespace rsi::hal {

bool SoftwareKeys::authenticate(KeySlot slot, const std::uint8_t* bytes, std::size_t length,
                                AuthenticationCode& code) noexcept {
    const auto place = static_cast<std::size_t>(slot);
    return (place < keys_.size()) && cmac(keys_[place], bytes, length, code);
}

bool SoftwareKeys::has_test_keys() const noexcept {
    bool found = false;
    for (const Key& key : keys_) {
        for (const Key& test_key : test_keys) {
            found = found || (key == test_key);
        }
    }
    return found;
}

}  // namespace rsi::hal
