// Travel direction: does the vehicle go forwards? The speed signal has no sign.
#pragma once

#include "rsi/numeric/bounded.hpp"

namespace rsi::monitoring {

// In reverse the yaw rate of a turn has the other sign, so yaw rate times speed is no lateral acceleration.
// Only a standstill can change the direction. From then on it is unknown until the vehicle is faster than
// any goes in reverse, or until a turn shows it.
class TravelDirection {
 public:
    // One sample. A speed that is not finite changes nothing.
    void update(float lateral_force_mps2, float yaw_rate_radps, float speed_mps) noexcept {
        if (forward_) {
            forward_ = !(speed_mps < standstill_mps);
            return;
        }
        const float turn_mps2 = yaw_rate_radps * speed_mps;
        const bool turns =
            rsi::smaller(rsi::absolute(lateral_force_mps2), rsi::absolute(turn_mps2)) > clear_turn_mps2;
        forward_ = (speed_mps > fastest_reverse_mps) || (turns && (lateral_force_mps2 * turn_mps2 > 0.0F));
    }

    bool is_forward() const noexcept { return forward_; }

 private:
    static constexpr float standstill_mps = 1.0F;
    static constexpr float fastest_reverse_mps = 14.0F;
    static constexpr float clear_turn_mps2 = 2.0F;

    bool forward_{true};  // as after a reset in the middle of a drive
};

}  // namespace rsi::monitoring
