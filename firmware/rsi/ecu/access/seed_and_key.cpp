#include "rsi/ecu/access/seed_and_key.hpp"

#include "rsi/ecu/access/same_code.hpp"
#include "rsi/ecu/access/stored_count.hpp"

namespace rsi::access {
namespace {

// From the third wrong key on the next seed is given 10 s later, then after twice as long each time. A guess
// has a chance of 2^-128: the delay keeps the bus and the memory of the count from being worn out rather than
// the key from being found, and more than ten minutes would only help who wants to keep others out.
constexpr std::uint32_t first_delayed_count = 3U;
constexpr std::uint32_t most_counted = 9U;
constexpr std::uint32_t first_delay_cycles = 1000U;

constexpr std::uint32_t delay_cycles_after(std::uint32_t wrong_keys) {
    return (wrong_keys < first_delayed_count) ? 0U
                                              : (first_delay_cycles << (wrong_keys - first_delayed_count));
}

constexpr std::uint32_t one_more(std::uint32_t wrong_keys) {
    return (wrong_keys < most_counted) ? (wrong_keys + 1U) : most_counted;
}

}  // namespace

// A count that is damaged, or larger than any that is written here, is taken for the largest: who can disturb
// its memory gains nothing.
void SeedAndKey::start() noexcept {
    stored_count_ = 0U;
    const CountState state = read_count(attempts_, CountOf::wrong_keys, stored_count_);
    const bool is_good = (state != CountState::damaged) && (stored_count_ <= most_counted);
    wrong_keys_ = is_good ? stored_count_ : most_counted;
    delay_cycles_ = delay_cycles_after(wrong_keys_);
    lock();
    is_started_ = true;
}

void SeedAndKey::lock() noexcept {
    is_unlocked_ = false;
    has_seed_ = false;
}

// The attempt is stored as a wrong one before it can be made: cutting the power in time to spare it is then
// of no use. Seeds that are not answered write no more than once, so asking for them does not wear the memory
// out.
bool SeedAndKey::give_seed(Block& seed) noexcept {
    has_seed_ = false;
    if (!is_started_ || (delay_cycles_ > 0U)) {
        return false;
    }
    Block fresh{};
    if (!random_.fill(fresh.data(), fresh.size()) || !store(one_more(wrong_keys_))) {
        return false;
    }
    seed_ = fresh;
    seed = fresh;
    has_seed_ = true;
    return true;
}

KeyAnswer SeedAndKey::take_key(const Block& key) noexcept {
    if (!has_seed_) {
        return KeyAnswer::no_seed;
    }
    lock();
    Block expected{};
    // A store that does not answer unlocks nothing.
    if (!keys_.authenticate(slot_, seed_.data(), seed_.size(), expected) || !is_same_code(key, expected)) {
        wrong_keys_ = one_more(wrong_keys_);
        delay_cycles_ = delay_cycles_after(wrong_keys_);
        return (delay_cycles_ > 0U) ? KeyAnswer::too_many_attempts : KeyAnswer::wrong_key;
    }
    is_unlocked_ = true;
    wrong_keys_ = 0U;
    static_cast<void>(
        store(0U));  // else the next attempt counts from what is stored: too strict, not too lax
    return KeyAnswer::unlocked;
}

bool SeedAndKey::store(std::uint32_t wrong_keys) noexcept {
    if ((wrong_keys != stored_count_) && !write_count(attempts_, CountOf::wrong_keys, wrong_keys)) {
        return false;
    }
    stored_count_ = wrong_keys;
    return true;
}

}  // namespace rsi::access
