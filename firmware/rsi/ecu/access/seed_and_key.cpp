#include "rsi/ecu/access/seed_and_key.hpp"

#include "rsi/ecu/access/same_code.hpp"
#include "rsi/ecu/access/stored_count.hpp"

namespace rsi::access {
namespace {

// The third wrong key starts a delay of 10 s; each further one doubles it, up to 640 s at the ninth. A guess
// succeeds with a probability of 2^-128, so the delay is there to limit bus load and wear of the memory.
// Longer delays would only ease a denial of service.
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

// A damaged count, or one above the largest that is ever written, counts as the largest, so that disturbing
// the memory gains nothing.
void SeedAndKey::start() noexcept {
    stored_count_ = 0U;
    const CountState state = read_count(attempts_, CountOf::wrong_keys, stored_count_);
    const bool is_good = (state != CountState::damaged) && (stored_count_ <= most_counted);
    wrong_keys_ = is_good ? stored_count_ : most_counted;
    delay_cycles_ = delay_cycles_after(wrong_keys_);
    unlocks_left_ = most_unlocks;
    lock();
    is_started_ = true;
}

void SeedAndKey::lock() noexcept {
    is_unlocked_ = false;
    has_seed_ = false;
}

// Stores the attempt as a wrong key before the seed is given, so that cutting the power afterwards does not
// save an attempt. Further seeds without a key write nothing, so requesting them does not wear the memory.
bool SeedAndKey::give_seed(Block& seed) noexcept {
    has_seed_ = false;
    if (!is_started_ || (delay_cycles_ > 0U) || (unlocks_left_ == 0U)) {
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
    // A key store that fails unlocks nothing.
    if (!keys_.authenticate(slot_, seed_.data(), seed_.size(), expected) || !is_same_code(key, expected)) {
        wrong_keys_ = one_more(wrong_keys_);
        delay_cycles_ = delay_cycles_after(wrong_keys_);
        return (delay_cycles_ > 0U) ? KeyAnswer::too_many_attempts : KeyAnswer::wrong_key;
    }
    is_unlocked_ = true;
    --unlocks_left_;
    wrong_keys_ = 0U;
    static_cast<void>(
        store(0U));  // if it fails, the stored count stays too high, which errs on the safe side
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
