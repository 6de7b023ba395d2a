// Seed and key: unlocks the protected services of XCP (GET_SEED, UNLOCK) and UDS (SecurityAccess, 0x27).
//
// The seed is a random block. The expected key is the AES-128-CMAC (RFC 4493) of the seed under a secret key
// in the key store.
#pragma once

#include <array>
#include <cstdint>

#include "rsi/hal/key_store.hpp"
#include "rsi/hal/random_source.hpp"
#include "rsi/hal/storage.hpp"

namespace rsi::access {

using Block = std::array<std::uint8_t, 16>;

enum class KeyAnswer : std::uint8_t {
    unlocked,
    wrong_key,
    no_seed,            // no seed was given, or a key has consumed it
    too_many_attempts,  // wrong key, and the delay has begun
};

class SeedAndKey {
 public:
    // All references must outlive this object. `attempts` stores a record of stored_count_length bytes for
    // this object alone; a write that it accepts must survive a loss of power from the next received frame
    // on, or an attacker could reset the count.
    SeedAndKey(hal::KeyStore& keys, hal::KeySlot slot, hal::RandomSource& random,
               hal::Storage& attempts) noexcept
        : keys_{keys}, slot_{slot}, random_{random}, attempts_{attempts} {}

    // Before the first cycle: reads the stored number of wrong keys. No seed is given before.
    [[gnu::cold]] void start() noexcept;

    // False, with `seed` unchanged: start() has not been called, the delay runs, the random source fails, the
    // storage does not take the attempt, or it has been unlocked so often since the start that more would
    // wear the storage. Invalidates any earlier seed, even then.
    bool give_seed(Block& seed) noexcept;

    // Consumes the seed, whatever the result, and locks unless the key is right.
    KeyAnswer take_key(const Block& key) noexcept;

    void lock() noexcept;

    bool is_unlocked() const noexcept { return is_unlocked_; }

    // The delay after wrong keys runs: no seed is given.
    bool is_delayed() const noexcept { return delay_cycles_ > 0U; }

    // Once in each cycle of 10 ms; counts the delay down.
    void end_cycle() noexcept {
        if (is_delayed()) {
            --delay_cycles_;
        }
    }

    static constexpr std::uint32_t most_unlocks = 100U;  // of a start

 private:
    bool store(std::uint32_t wrong_keys) noexcept;

    hal::KeyStore& keys_;
    hal::KeySlot slot_;
    hal::RandomSource& random_;
    hal::Storage& attempts_;
    Block seed_{};
    bool has_seed_{false};
    bool is_started_{false};
    bool is_unlocked_{false};
    std::uint32_t wrong_keys_{0U};    // since the last right one; saturates
    std::uint32_t stored_count_{0U};  // in attempts_; counts a seed that waits for its key as a wrong key
    std::uint32_t delay_cycles_{0U};  // left
    std::uint32_t unlocks_left_{most_unlocks};
};

}  // namespace rsi::access
