// Seed and key: who knows the key may change something. For XCP (GET_SEED, UNLOCK) and UDS (service 27).
//
// The seed is a random block, the key its AES-128-CMAC (RFC 4493), computed by the key store.
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
    no_seed,            // none was given, or it is used up
    too_many_attempts,  // wrong, and a delay has begun in which no seed is given
};

class SeedAndKey {
 public:
    // All three must outlive this object. `attempts` takes a record of stored_count_length bytes and is
    // used by this object only. A record that it has taken must be safe from a loss of power before the next
    // frame is answered.
    SeedAndKey(hal::KeyStore& keys, hal::KeySlot slot, hal::RandomSource& random,
               hal::Storage& attempts) noexcept
        : keys_{keys}, slot_{slot}, random_{random}, attempts_{attempts} {}

    // Before the first cycle: reads how many wrong keys there have been. Until then no seed is given.
    [[gnu::cold]] void start() noexcept;

    // False while the delay after wrong keys runs, without random numbers, and where the attempt cannot be
    // stored; `seed` is then left as it was. A seed that was given before is of no use any more.
    bool give_seed(Block& seed) noexcept;

    // Consumes the seed, whatever the answer. A wrong key locks again.
    KeyAnswer take_key(const Block& key) noexcept;

    void lock() noexcept;

    bool is_unlocked() const noexcept { return is_unlocked_; }

    // After wrong keys: no seed is given for a while.
    bool is_delayed() const noexcept { return delay_cycles_ > 0U; }

    // Counts the delay down, once a cycle of 10 ms.
    void end_cycle() noexcept {
        if (is_delayed()) {
            --delay_cycles_;
        }
    }

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
    std::uint32_t wrong_keys_{0U};    // since the last good one
    std::uint32_t stored_count_{0U};  // in `attempts`: one more while a seed waits for its key
    std::uint32_t delay_cycles_{0U};
};

}  // namespace rsi::access
