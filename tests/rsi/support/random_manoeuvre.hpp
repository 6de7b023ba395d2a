// A random, reproducible drive that goes to the limits: both directions, banked road, noise, missing values.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "rsi/rsi.h"
#include "tests/rsi/support/body_kinematics.hpp"
#include "tests/rsi/support/recorded_like_signals.hpp"
#include "tests/rsi/support/roll_plane_vehicle.hpp"

namespace rsi_test {

class RandomManoeuvre {
 public:
    // `gaps` lets a necessary input be missing for a moment now and then.
    RandomManoeuvre(const rsi_parameters& parameters, std::uint64_t seed, bool gaps)
        : vehicle_(parameters, Deviation{0.05, -5.0e3, 500.0}), noise_(seed), gaps_(gaps) {}

    rsi_inputs next() {
        if (noise_.unit() < 0.01) {  // a new steering input about once a second
            wanted_mps2_ = 22.0 * noise_.unit() - 11.0;
            wanted_bank_rad_ = 0.4 * noise_.unit() - 0.2;
        }
        motion_.lateral_acceleration_mps2 += 0.05 * (wanted_mps2_ - motion_.lateral_acceleration_mps2);
        motion_.bank_angle_rad += 0.01 * (wanted_bank_rad_ - motion_.bank_angle_rad);
        motion_.roll_angle_rad = vehicle_.angle_rad();
        const PlaneVector force = specific_force_along(motion_, motion_.bank_angle_rad);

        rsi_inputs inputs = sensed(motion_);
        inputs.roll_rate_radps =
            static_cast<float>(vehicle_.rate_radps(force.left, force.up, motion_.roll_angle_rad));
        inputs.yaw_rate_radps = static_cast<float>(motion_.lateral_acceleration_mps2 / 20.0);
        inputs.speed_mps = 20.0F;
        // Now more, now less than the force it goes with, and ahead of it.
        inputs.steering_wheel_angle_rad = static_cast<float>(0.2 * wanted_mps2_);
        add_noise(noise_, inputs);
        drop_values(inputs);
        vehicle_.advance(force.left, force.up, 0.01);
        return inputs;
    }

 private:
    void drop_values(rsi_inputs& inputs) {
        const float missing = std::numeric_limits<float>::quiet_NaN();
        if (noise_.unit() < 0.02) {
            inputs.vertical_specific_force_mps2 = missing;
        }
        if (noise_.unit() < 0.02) {
            inputs.yaw_rate_radps = missing;
        }
        if (noise_.unit() < 0.02) {
            inputs.bank_angle_rad = missing;
        }
        if (noise_.unit() < 0.02) {
            inputs.steering_wheel_angle_rad = missing;
        }
        if (gaps_ && (noise_.unit() < 0.002)) {
            inputs.roll_angle_rad = missing;
        }
    }

    RollPlaneVehicle vehicle_;
    Noise noise_;
    bool gaps_;
    GroundMotion motion_{};
    double wanted_mps2_{5.0};
    double wanted_bank_rad_{0.0};
};

}  // namespace rsi_test
