// Slow vehicle: whether one that hardly moves can have such a lateral acceleration.
#pragma once

#include <cstdint>

#include "rsi/ecu/monitoring/driving_speed.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// It turns with what yaw rate and speed say, stands on no road steeper than 45 %, leans with its body, and
// sways when it stops: over 60 drawn drives and runs that came to a stop, all but the turn came to 7.9 m/s^2.
// The wheels of a vehicle that slides sideways are slow too, and at the end of the slide it may tip over.
class SlowVehicle {
 public:
    // One sample. A value that is not finite is not impossible.
    void update(const rsi::Inputs& inputs) noexcept {
        const float turn_mps2 = rsi::absolute(inputs.yaw_rate_radps * inputs.speed_mps);
        const float beyond_mps2 = rsi::absolute(inputs.lateral_specific_force_mps2) - turn_mps2;
        const bool calm = (beyond_mps2 < least_of_slide_mps2);
        const std::uint32_t more = ((samples_ < enough_samples) && calm) ? samples_ + 1U : samples_;
        samples_ = rsi::is_within(inputs.speed_mps, 0.0F, driving_speed_mps) ? more : 0U;
        impossible_ = (samples_ == enough_samples) && (beyond_mps2 > most_beyond_turn_mps2);
    }

    bool lateral_acceleration_is_impossible() const noexcept { return impossible_; }

 private:
    static constexpr float most_beyond_turn_mps2 = 8.5F;
    static constexpr float least_of_slide_mps2 = 4.0F;
    static constexpr std::uint32_t enough_samples = 300U;

    std::uint32_t samples_{enough_samples};  // initially: slow, not sliding
    bool impossible_{false};
};

}  // namespace rsi::monitoring
