#include "monitoring/roll_consistency.hpp"

namespace monitoring {

void RollConsistency::update(float roll_angle_rad, float roll_rate_radps) noexcept {
    if (!rsi::is_finite(roll_angle_rad) || !rsi::is_finite(roll_rate_radps) ||
        !rsi::is_within_magnitude(turned_rad_, largest_turn_rad)) {
        filled_ = 0U;
        turned_rad_ = 0.0F;
        return;
    }
    turned_rad_ += rsi::sample_time_s * roll_rate_radps;
    const float difference = roll_angle_rad - turned_rad_;
    short_rad_ = change(difference, short_window);
    long_rad_ = change(difference, long_window);
    history_[next_] = difference;
    next_ = (next_ + 1U < long_window) ? next_ + 1U : 0U;
    filled_ = (filled_ < long_window) ? filled_ + 1U : long_window;
}

float RollConsistency::change(float difference, std::size_t window) const noexcept {
    if (filled_ < window) {
        return 0.0F;
    }
    const std::size_t index = (next_ >= window) ? next_ - window : next_ + long_window - window;
    return difference - history_[index];
}

}  // namespace monitoring
