#include "rsi/ecu/monitoring/roll_consistency.hpp"

namespace rsi::monitoring {
namespace {

// An accelerometer's noise is as large as what is looked for.
constexpr float inclination_lag_s = 0.05F;

}  // namespace

void RollConsistency::update(float roll_angle_rad, float roll_rate_radps, float inclination_rad) noexcept {
    if (!rsi::is_finite(roll_angle_rad) || !rsi::is_finite(roll_rate_radps) ||
        !rsi::is_within_magnitude(turned_rad_, largest_turn_rad) || (next_ >= long_window)) {
        filled_ = 0U;
        next_ = 0U;  // within the history, whatever has become of it in memory
        turned_rad_ = 0.0F;
        return;
    }
    turned_rad_ += rsi::sample_time_s * roll_rate_radps;
    // The roll angle alone, where no inclination is known.
    const float shown_rad = rsi::is_finite(inclination_rad) ? inclination_rad : roll_angle_rad;
    const bool begins = (filled_ == 0U);
    const float weight = begins ? 1.0F : rsi::sample_time_s / inclination_lag_s;
    inclined_rad_ += weight * (shown_rad - turned_rad_ - inclined_rad_);
    const Beyond now{roll_angle_rad - turned_rad_, inclined_rad_};
    short_ = change(now, short_window);
    long_ = change(now, long_window);
    history_[next_] = now;
    next_ = (next_ + 1U < long_window) ? next_ + 1U : 0U;
    filled_ = (filled_ < long_window) ? filled_ + 1U : long_window;
}

RollConsistency::Beyond RollConsistency::change(const Beyond& now, std::size_t window) const noexcept {
    if (filled_ < window) {
        return Beyond{};
    }
    const std::size_t index = (next_ >= window) ? next_ - window : next_ + long_window - window;
    return Beyond{now.roll_angle_rad - history_[index].roll_angle_rad,
                  now.inclination_rad - history_[index].inclination_rad};
}

}  // namespace rsi::monitoring
