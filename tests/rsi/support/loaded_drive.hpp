// Ordinary driving of a vehicle whose load is not that of the calibration: the roll equation with the roll
// inertia, integrated in double with small steps, under turns of both directions up to 0.4 g.
#pragma once

#include <cmath>
#include <cstdint>

#include "rsi/indicator/load_transfer.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/rsi.h"
#include "tests/rsi/support/body_kinematics.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/recorded_like_signals.hpp"

namespace rsi_test {

// How the vehicle and its drive differ from the calibration and from driving in both directions alike.
struct LoadedVehicle {
    double excess{0.0};             // m_s H over the calibrated one, less 1; Ixx grows with it
    double stiffness_share{1.0};    // the vehicle's K over the calibrated one
    double force_offset_mps2{0.0};  // offset of the accelerometer
    double angle_offset_rad{0.0};   // offset of the roll sensor
    double noise_share{1.0};        // of the noise of a production sensor
    int direction{0};               // of all turns: 1 left, -1 right, 0 both
    double side{1.0};               // -1 mirrors the drive
    double strength{1.0};           // of the turns: 1 up to 0.4 g
};

class LoadedDrive {
 public:
    LoadedDrive(const rsi_parameters& calibration, const LoadedVehicle& vehicle, std::uint64_t seed = 1U)
        : p_{calibration},
          vehicle_{vehicle},
          chance_{seed},
          noise_{seed + 1U},
          calibrated_{calibration},
          inertial_weight_{calibration.load_transfer_inertial_weight} {}

    // The next sample: what the component's filter would make of good sensors, less its delay.
    void advance() {
        if (time_to_turn_s_ <= 0.0) {
            begin_segment();
        }
        time_to_turn_s_ -= 0.01;
        force_mps2_ += 0.02 * (wanted_mps2_ - force_mps2_);
        constexpr int parts = 5;
        for (int part = 0; part < parts; ++part) {
            const double dt = 0.01 / parts;
            rate_radps_ += dt * acceleration_radps2();
            angle_rad_ += dt * rate_radps_;
        }
    }

    rsi::RollMotion motion() {
        rsi::RollMotion motion;
        motion.road_parallel_force_mps2 = static_cast<float>(measured_force_mps2());
        motion.road_normal_force_mps2 = static_cast<float>(gravity_mps2);
        motion.roll_angle_rad = static_cast<float>(measured_angle_rad());
        motion.roll_rate_radps = static_cast<float>(vehicle_.side * rate_radps_);
        motion.roll_acceleration_radps2 = static_cast<float>(vehicle_.side * acceleration_radps2());
        return motion;
    }

    // The load that the calibrated vehicle transfers in a motion.
    rsi::TransferredLoad load(const rsi::RollMotion& motion) const {
        return rsi::transferred_load(calibrated_, inertial_weight_, motion);
    }

    // The sensors of the same sample, at `speed_mps`.
    rsi_inputs inputs(double speed_mps) {
        GroundMotion motion;
        motion.lateral_acceleration_mps2 = measured_force_mps2();
        motion.roll_angle_rad = vehicle_.side * angle_rad_;
        rsi_inputs inputs = sensed(motion);
        inputs.roll_angle_rad = static_cast<float>(measured_angle_rad());
        inputs.roll_rate_radps = static_cast<float>(vehicle_.side * rate_radps_);
        inputs.yaw_rate_radps = static_cast<float>(vehicle_.side * force_mps2_ / speed_mps);
        inputs.speed_mps = static_cast<float>(speed_mps);
        inputs.steering_wheel_angle_rad = static_cast<float>(0.2 * vehicle_.side * force_mps2_);
        return inputs;
    }

    double force_mps2() const { return vehicle_.side * force_mps2_; }

 private:
    void begin_segment() {
        time_to_turn_s_ = 2.0 + 5.0 * chance_.unit();
        const bool straight = chance_.unit() < 0.4;
        const double size = vehicle_.strength * (1.0 + 2.9 * chance_.unit());
        const double drawn_side = (chance_.unit() < 0.5) ? -1.0 : 1.0;
        const double side = (vehicle_.direction == 0) ? drawn_side : static_cast<double>(vehicle_.direction);
        wanted_mps2_ = straight ? 0.0 : side * size;
    }

    double acceleration_radps2() const {
        const double z = angle_rad_ * angle_rad_;
        const double spring_nm =
            vehicle_.stiffness_share * angle_rad_ *
            (wide(p_.roll_stiffness_nmprad) +
             z * (wide(p_.roll_stiffness_cubic_nmprad3) + z * wide(p_.roll_stiffness_quintic_nmprad5)));
        const double arm_kgm = (1.0 + vehicle_.excess) * wide(p_.sprung_mass_kg) *
                               (wide(p_.sprung_cg_height_m) - wide(p_.fixed_roll_centre_height_m));
        const double inertia = (1.0 + vehicle_.excess) * wide(p_.roll_inertia_kgm2);
        return (arm_kgm * (force_mps2_ + gravity_mps2 * std::tan(angle_rad_)) - spring_nm -
                wide(p_.roll_damping_nmsprad) * rate_radps_) /
               inertia;
    }

    // Through the component's lags a third of the noise is left.
    double measured_force_mps2() {
        return vehicle_.side * force_mps2_ + vehicle_.force_offset_mps2 +
               noise_(0.3 * vehicle_.noise_share * force_noise_mps2);
    }
    double measured_angle_rad() {
        return vehicle_.side * angle_rad_ + vehicle_.angle_offset_rad +
               noise_(0.3 * vehicle_.noise_share * angle_noise_rad);
    }

    static double wide(float value) { return static_cast<double>(value); }

    rsi_parameters p_;
    LoadedVehicle vehicle_;
    Noise chance_;
    Noise noise_;
    rsi::Vehicle calibrated_;
    float inertial_weight_;
    double force_mps2_{0.0};
    double wanted_mps2_{0.0};
    double time_to_turn_s_{0.0};
    double angle_rad_{0.0};
    double rate_radps_{0.0};
};

}  // namespace rsi_test
