// Road bank: what an angle of the body against the horizon is more than that against the road.
#pragma once

#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi {

// The difference between the sensor's angle and the roll that the observer finds without it, through a lag.
// No error of the sensor that stays, and no drift, gets through. The observer's roll is off by some share of
// itself, a real bank changes within a second: the more the body rolls, the longer the lag. Thus the sensor
// gives the quick part, most of all in a hard turn, and the observer the lasting one. An angle steeper than
// any road does not count as a bank; it remains in the angle, where the check of the roll sensor sees it.
class RoadBank {
 public:
    void reset() { known_ = false; }

    // One sample: the sensor's angle, and the body's against the road as the observer has it.
    void follow(float against_horizon_rad, float against_road_rad) {
        const float now_rad = clamp_magnitude(against_horizon_rad - against_road_rad, steepest_rad);
        if (!known_) {
            angle_rad_ = now_rad;
            known_ = true;
        } else {
            const float lag_s = least_lag_s + lag_per_roll_s * absolute(against_road_rad);
            angle_rad_ += (sample_time_s / lag_s) * (now_rad - angle_rad_);
        }
    }

    bool known() const { return known_; }
    float angle_rad() const { return angle_rad_; }

 private:
    static constexpr float steepest_rad = 0.42F;  // 45 %
    static constexpr float least_lag_s = 0.05F;
    static constexpr float lag_per_roll_s = 5.0F;  // per rad: half a second at 5 deg

    float angle_rad_{};
    bool known_{false};
};

}  // namespace rsi
