// Roll-plane vehicle: what the sensors of a vehicle see that obeys the roll-plane model exactly.
#pragma once

#include "rsi/types.hpp"
#include "tests/application/bench.hpp"

namespace testing_application {

// c phi' + K phi = m H (A + g tan phi), H = h - h_rc, on a level road (A = a_y, N = g), in double precision.
class RollPlaneVehicle {
 public:
    explicit RollPlaneVehicle(const rsi::Parameters& parameters) : parameters_{parameters} {}

    // Moves on by 10 ms with this lateral acceleration at the end.
    void advance(double lateral_acceleration_mps2);

    Motion motion() const;
    double lateral_acceleration_mps2() const { return acceleration_mps2_; }
    double roll_angle_rad() const { return angle_rad_; }

    // Lateral acceleration at which the moments about the outer wheels balance for this roll angle, while the
    // roll centre has not moved: g (c_w/2 - H tan phi) / h, on the side of the turn.
    double threshold_mps2() const;

 private:
    double roll_rate_radps() const;

    rsi::Parameters parameters_;
    double acceleration_mps2_{0.0};
    double angle_rad_{0.0};
};

}  // namespace testing_application
