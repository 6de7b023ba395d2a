// Roll reference check: is the roll angle measured against what the calibration says, the road or the
// horizon?
#pragma once

#include <cstdint>

#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// On a banked road an angle against the horizon contains the bank, one against the road does not. On a level
// one both are the same, and in a hard turn the bank is less than what the observer's roll may be off by:
// only a clear bank under a body that hardly rolls shows which of the two it is.
class RollReferenceCheck {
 public:
    void start(const rsi::Parameters& parameters) noexcept {
        against_horizon_ = (parameters.roll_angle_reference == RSI_ROLL_AGAINST_HORIZON);
        shows_ = false;
        samples_ = 0U;
    }

    // One sample: the sensor's angle, the body's against the road as the observer has it, and the road's
    // bank, measured or observed. One that is not finite shows nothing.
    void update(float sensor_rad, float observed_roll_rad, float bank_rad) noexcept {
        const float bank = rsi::absolute(bank_rad);
        const bool clear = (bank > clear_bank_rad) && (rsi::absolute(observed_roll_rad) < 0.5F * bank);
        const float beyond_road = rsi::absolute(sensor_rad - observed_roll_rad);
        const float beyond_horizon = rsi::absolute(sensor_rad - observed_roll_rad - bank_rad);
        const bool is_against_road = clear && (beyond_road < 0.3F * bank);
        const bool is_against_horizon = clear && (beyond_horizon < 0.3F * bank);
        shows_ = is_against_road || is_against_horizon;
        if (!shows_) {
            return;
        }
        if (is_against_horizon == against_horizon_) {
            samples_ -= (samples_ > 0U) ? 1U : 0U;
        } else {
            samples_ += (samples_ < enough_samples) ? 1U : 0U;
        }
    }

    // Whether this sample shows one or the other.
    bool known() const noexcept { return shows_; }
    // For 5 s, those in which it agreed taken off, the angle was what the calibration says that it is not.
    bool contradicts() const noexcept { return samples_ == enough_samples; }

 private:
    // An accelerometer's bias of 0.03 g feigns 0.03 rad; with less of a real bank beside it than would let
    // one of the two angles pass for the other, it comes to less than this.
    static constexpr float clear_bank_rad = 0.05F;
    static constexpr std::uint32_t enough_samples = 500U;

    bool against_horizon_{false};
    bool shows_{false};
    std::uint32_t samples_{0U};
};

}  // namespace rsi::monitoring
