// The key to a seed: its AES-128-CMAC. The key of it is the public test key; a product puts its own here, and
// gives the library to those only who may unlock its control units.
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/software_keys/software_keys.hpp"

#ifdef _WIN32
#define RSI_EXPORT extern "C" __declspec(dllexport)
#else
#define RSI_EXPORT extern "C" __attribute__((visibility("default")))
#endif

namespace sil {

inline constexpr std::size_t seed_length = 16U;

// False for a seed of another length.
inline bool answer(rsi::hal::KeySlot slot, const std::uint8_t* seed, std::size_t length,
                   rsi::hal::AuthenticationCode& code) {
    return length == seed_length &&
           rsi::hal::cmac(rsi::hal::test_keys.at(static_cast<std::size_t>(slot)), seed, length, code);
}

}  // namespace sil
