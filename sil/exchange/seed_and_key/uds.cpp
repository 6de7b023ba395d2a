// Seed-and-key library for UDS testers: GenerateKeyEx, as CANoe, CANape and others call it for service 0x27.
#include <algorithm>
#include <cstdint>

#include "sil/exchange/seed_and_key/answer.hpp"

namespace {

constexpr unsigned level_of_the_seed = 1U;  // 0x27 0x01; the only one

// Answers that the interface gives a number.
constexpr int ok = 0;
constexpr int buffer_too_small = 1;
constexpr int security_level_invalid = 2;
constexpr int unspecified_error = 4;

}  // namespace

// `length`: of the key. The variant of the ECU is not asked for: there is one.
RSI_EXPORT int GenerateKeyEx(const std::uint8_t* seed, unsigned seed_length, unsigned level,
                             const char* /*variant*/, std::uint8_t* key, unsigned room, unsigned* length) {
    rsi::hal::AuthenticationCode code{};
    if (level != level_of_the_seed) {
        return security_level_invalid;
    }
    if (room < code.size()) {
        return buffer_too_small;
    }
    if (!sil::answer(rsi::hal::KeySlot::diagnosis, seed, seed_length, code)) {
        return unspecified_error;
    }
    std::copy(code.begin(), code.end(), key);
    *length = static_cast<unsigned>(code.size());
    return ok;
}
