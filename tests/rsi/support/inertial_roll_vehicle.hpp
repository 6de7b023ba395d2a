// A body with roll inertia, a stiffness curve and a displaced roll centre, integrated in double with small
// steps: the vehicle that the second estimator takes the real one for.
#pragma once

#include <cmath>

#include "rsi/measurement/measurement.hpp"
#include "rsi/rsi.h"

namespace rsi_test {

struct InertialDeviation {
    double vertical_m{0.0};        // dh
    double stiffness_factor{1.0};  // on the whole curve
    double offset_mps2{0.0};       // of the lateral accelerometer
};

class InertialRollVehicle {
 public:
    InertialRollVehicle(const rsi_parameters& parameters, const InertialDeviation& deviation)
        : p_(parameters), deviation_(deviation) {}

    // Drives 10 ms under a road-parallel force that moves there in a straight line, and measures without
    // noise.
    rsi::Measurement drive(double parallel_mps2) {
        constexpr int steps = 100;
        constexpr double dt = 0.01 / steps;
        const double from = parallel_mps2_;
        for (int k = 1; k <= steps; ++k) {
            parallel_mps2_ = from + (parallel_mps2 - from) * k / steps;
            rate_radps_ += dt * acceleration_radps2();
            angle_rad_ += dt * rate_radps_;
        }
        rsi::Measurement measured;
        measured.road_parallel_force_mps2 = static_cast<float>(parallel_mps2_ + deviation_.offset_mps2);
        measured.road_normal_force_mps2 = static_cast<float>(gravity);
        measured.lateral_acceleration_mps2 = measured.road_parallel_force_mps2;
        measured.roll_angle_rad = static_cast<float>(angle_rad_);
        measured.roll_rate_radps = static_cast<float>(rate_radps_);
        measured.tan_roll_angle = static_cast<float>(std::tan(angle_rad_));
        return measured;
    }

    double angle_rad() const { return angle_rad_; }
    double rate_radps() const { return rate_radps_; }
    double acceleration_radps2() const {
        const double phi = angle_rad_;
        const double stiffness_nm = phi * (wide(p_.roll_stiffness_nmprad) +
                                           phi * phi *
                                               (wide(p_.roll_stiffness_cubic_nmprad3) +
                                                phi * phi * wide(p_.roll_stiffness_quintic_nmprad5)));
        const double arm_m =
            wide(p_.sprung_cg_height_m) - wide(p_.fixed_roll_centre_height_m) - deviation_.vertical_m;
        const double moment_nm =
            wide(p_.sprung_mass_kg) * arm_m * (parallel_mps2_ + gravity * std::tan(phi)) -
            deviation_.stiffness_factor * stiffness_nm - wide(p_.roll_damping_nmsprad) * rate_radps_;
        return moment_nm / wide(p_.roll_inertia_kgm2);
    }

 private:
    static constexpr double gravity = 9.80665;
    static double wide(float value) { return static_cast<double>(value); }

    rsi_parameters p_;
    InertialDeviation deviation_;
    double parallel_mps2_{0.0};
    double angle_rad_{0.0};
    double rate_radps_{0.0};
};

}  // namespace rsi_test
