// A vehicle that rolls by the observer's equations exactly, in a slalom or straight on, onto a bank.
#pragma once

#include <cmath>
#include <limits>

#include "rsi/rsi.h"
#include "tests/rsi/support/nominal.hpp"

namespace rsi_test {

struct Drive {
    double speed_mps{25.0};
    double largest_acceleration_mps2{0.0};  // of the turn, a sine of 0.4 Hz
    double bank_rad{0.0};                   // reached between 2 and 5 s
    double gyro_bias_radps{0.0};
};

// Roll by Ixx w' = m_s H f_yb / cos phi - M(phi) - c phi', phi' = w - b', in double with steps of 0.1 ms; no
// sideslip, so the turn's kinematics hold exactly.
class RollingVehicle {
 public:
    RollingVehicle(const rsi_parameters& parameters, const Drive& drive)
        : parameters_{parameters}, drive_{drive} {}

    void advance_10_ms() {
        constexpr double step_s = 1.0e-4;
        for (int k = 0; k < 100; ++k) {
            const double bank_rate_radps = (bank(time_s_ + step_s) - bank(time_s_)) / step_s;
            const double z = phi_ * phi_;
            const double moment_nm = phi_ * (value(parameters_.roll_stiffness_nmprad) +
                                             z * (value(parameters_.roll_stiffness_cubic_nmprad3) +
                                                  z * value(parameters_.roll_stiffness_quintic_nmprad5)));
            const double arm_m =
                value(parameters_.sprung_cg_height_m) - value(parameters_.fixed_roll_centre_height_m);
            const double roll_rate_radps = w_ - bank_rate_radps;
            w_ += step_s *
                  (value(parameters_.sprung_mass_kg) * arm_m * force() / std::cos(phi_) - moment_nm -
                   value(parameters_.roll_damping_nmsprad) * roll_rate_radps) /
                  value(parameters_.roll_inertia_kgm2);
            phi_ += step_s * (w_ - bank_rate_radps);
            time_s_ += step_s;
        }
    }

    // Inputs of sensors at the CG, the roll angle against the road; neither heave nor a bank sensor.
    rsi_inputs inputs() const {
        rsi_inputs inputs{};
        inputs.lateral_specific_force_mps2 = static_cast<float>(force());
        inputs.vertical_specific_force_mps2 = std::numeric_limits<float>::quiet_NaN();
        inputs.roll_rate_radps = static_cast<float>(w_ + drive_.gyro_bias_radps);
        inputs.roll_angle_rad = static_cast<float>(phi_);
        inputs.yaw_rate_radps = static_cast<float>(acceleration() / drive_.speed_mps);
        inputs.bank_angle_rad = std::numeric_limits<float>::quiet_NaN();
        inputs.speed_mps = static_cast<float>(drive_.speed_mps);
        inputs.steering_wheel_angle_rad = std::numeric_limits<float>::quiet_NaN();
        return inputs;
    }

    double roll_angle_rad() const { return phi_; }
    double bank_angle_rad() const { return bank(time_s_); }

 private:
    static double value(float number) { return static_cast<double>(number); }
    double bank(double time_s) const {
        const double share = std::fmin(std::fmax((time_s - 2.0) / 3.0, 0.0), 1.0);
        return drive_.bank_rad * 0.5 * (1.0 - std::cos(pi * share));
    }
    double acceleration() const {
        return drive_.largest_acceleration_mps2 * std::sin(2.0 * pi * 0.4 * time_s_);
    }
    double force() const { return acceleration() + gravity_mps2 * std::sin(phi_ + bank(time_s_)); }

    rsi_parameters parameters_;
    Drive drive_;
    double time_s_{0.0};
    double phi_{0.0};
    double w_{0.0};
};

}  // namespace rsi_test
