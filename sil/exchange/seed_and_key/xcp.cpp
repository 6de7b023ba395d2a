// Seed-and-key library for CANape and INCA: the functions that ASAM's interface for XCP names, which a tool
// calls between GET_SEED and UNLOCK. The A2L names the library, SeedNKeyXcp.dll.
#include <algorithm>
#include <cstdint>

#include "sil/exchange/seed_and_key/answer.hpp"

namespace {

// Resources that are locked; a key for one unlocks both.
constexpr std::uint8_t calibration = 0x01U;  // CAL/PAG
constexpr std::uint8_t measurement = 0x04U;  // DAQ

// Answers that the interface gives a number.
constexpr std::uint32_t acknowledged = 0U;
constexpr std::uint32_t no_such_privilege = 1U;
constexpr std::uint32_t seed_of_another_length = 2U;
constexpr std::uint32_t key_does_not_fit = 3U;

}  // namespace

RSI_EXPORT std::uint32_t XCP_GetAvailablePrivileges(std::uint8_t* privileges) {
    *privileges = calibration | measurement;
    return acknowledged;
}

// `key_length`: in, the room in `key`; out, the length of the key.
RSI_EXPORT std::uint32_t XCP_ComputeKeyFromSeed(std::uint8_t privilege, std::uint8_t seed_length,
                                                const std::uint8_t* seed, std::uint8_t* key_length,
                                                std::uint8_t* key) {
    if (privilege != calibration && privilege != measurement) {
        return no_such_privilege;
    }
    rsi::hal::AuthenticationCode code{};
    if (*key_length < code.size()) {
        return key_does_not_fit;
    }
    if (!sil::answer(rsi::hal::KeySlot::calibration, seed, seed_length, code)) {
        return seed_of_another_length;
    }
    std::copy(code.begin(), code.end(), key);
    *key_length = static_cast<std::uint8_t>(code.size());
    return acknowledged;
}
