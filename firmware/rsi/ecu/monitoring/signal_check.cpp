#include "rsi/ecu/monitoring/signal_check.hpp"

#include "rsi/numeric/saturating_count.hpp"

namespace rsi::monitoring {
namespace {

constexpr std::uint32_t most_bursts = 3U;
constexpr std::uint32_t burst_memory = 6000U;  // samples, a minute

}  // namespace

float SignalCheck::qualify(float value, DiagnosticMemory& memory, const SignalSupport& support) noexcept {
    const bool valid = rsi::is_within(value, limits_.minimum, limits_.maximum);
    if (!rsi::is_finite(value)) {
        memory.report(limits_.invalid, true);
        forget();
        return rsi::not_available;
    }
    const bool unsteady =
        (known_ && has_jumped(value, support.expected_change)) || is_shaken(value, support.road_shake);
    const bool good = valid && !unsteady;
    if (bursts_ > 0U) {
        rsi::count_up(calm_samples_);
    }
    if (good && known_ && is_doubted(value, support) && !is_failing(memory)) {
        rsi::count_up(doubted_samples_);
        return good_;
    }
    if (good && (doubted_samples_ == 0U) && memory.no_active_codes()) {
        memory.add_tested(codes_);
        keep(value);
        return value;
    }
    memory.report(limits_.invalid, !valid);
    if (valid) {
        memory.report(limits_.jumps, unsteady);
        memory.add_tested(codes_);
    }
    if (good && (doubted_samples_ > 0U) && support.vehicle_is_calm && !is_far(value, support)) {
        count_burst(memory);
    }
    if (is_failing(memory)) {
        // From now on each value is compared with the one before: smooth again is good again.
        good_ = value;
        known_ = valid;
        doubted_samples_ = 0U;
        return rsi::not_available;
    }
    if (good) {
        keep(value);
    } else if (known_) {
        rsi::count_up(doubted_samples_);
    } else {
        // No value yet that later ones could be compared with.
    }
    return known_ ? good_ : rsi::not_available;
}

// The signal is back where it was, so the values between were none of its own.
void SignalCheck::count_burst(DiagnosticMemory& memory) noexcept {
    bursts_ = (calm_samples_ < burst_memory) ? bursts_ + 1U : 1U;
    calm_samples_ = 0U;
    if (bursts_ >= most_bursts) {
        bursts_ = most_bursts;
        memory.confirm(limits_.jumps);
    }
}

// The second difference of white noise is 2.4 times as large as the noise, that of a vehicle's motion next to
// nothing.
bool SignalCheck::is_shaken(float value, float road_shake) noexcept {
    // Bounded, so that a single value that is off, which bends three times, does not come to it.
    const float bend = rsi::smaller(rsi::absolute(value - 2.0F * last_ + before_), 3.5F * limits_.shake);
    const float grown = shake_ + 0.1F * (bend - shake_);
    shake_ = (values_ >= 2U) ? grown : 0.0F;
    values_ = (values_ < 2U) ? values_ + 1U : 2U;
    before_ = last_;
    last_ = value;
    return !rsi::is_within_magnitude(shake_, limits_.shake + road_shake);
}

}  // namespace rsi::monitoring
