// Starting angle: may the roll angle be used that the sensor shows after a start?
#pragma once

#include <cstdint>

#include "rsi/numeric/bounded.hpp"

namespace rsi::monitoring {

// The observer needs some tenths of a second to contradict a sensor. An angle that no everyday driving has
// would warn meanwhile, so it waits for the observer's confirmation.
class StartingAngle {
 public:
    // One sample; the angle's excess over the observer's is NaN while that is not known. True while the angle
    // is not to be used.
    bool waits(float angle_rad, float beyond_observed_rad) noexcept {
        contradicted_ = false;
        if (settled_ || !rsi::is_finite(angle_rad)) {
            return false;
        }
        samples_ += 1U;
        settled_ = rsi::is_within_magnitude(angle_rad, everyday_rad) ||
                   rsi::is_within_magnitude(beyond_observed_rad, agreement_rad);
        if (!settled_ && (samples_ >= longest_wait)) {
            settled_ = true;
            contradicted_ = rsi::is_finite(beyond_observed_rad);
        }
        return !settled_;
    }

    // The wait has just ended, and the observer did not confirm the angle.
    bool is_contradicted() const noexcept { return contradicted_; }

 private:
    static constexpr float everyday_rad = 0.1F;
    static constexpr float agreement_rad = 0.05F;
    static constexpr std::uint32_t longest_wait = 40U;

    std::uint32_t samples_{0U};
    bool settled_{false};
    bool contradicted_{false};
};

}  // namespace rsi::monitoring
