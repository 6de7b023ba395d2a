// Deterministic signals such as a drive records: several sines of lateral acceleration plus sensor noise,
// turns of both directions.
#pragma once

#include <cmath>
#include <cstdint>

#include "rsi/rsi.h"
#include "tests/rsi/support/body_kinematics.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/roll_plane_vehicle.hpp"

namespace rsi_test {

// Uniform noise with the same numbers everywhere (the standard library's distributions differ).
class Noise {
 public:
    explicit Noise(std::uint64_t seed) : state_(seed) {}

    // Zero mean, standard deviation `deviation`, bounded to sqrt(3) times that.
    double operator()(double deviation) { return deviation * std::sqrt(3.0) * (2.0 * unit() - 1.0); }

    // 0 to below 1.
    double unit() { return static_cast<double>(bits()) / 4294967296.0; }

    std::uint32_t bits() {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<std::uint32_t>(state_ >> 32U);
    }

 private:
    std::uint64_t state_;
};

// Standard deviations of a production IMU and roll sensor.
constexpr double force_noise_mps2 = 0.02 * gravity_mps2;
constexpr double rate_noise_radps = 0.3 * pi / 180.0;
constexpr double angle_noise_rad = 0.2 * pi / 180.0;

inline void add_noise(Noise& noise, rsi_inputs& inputs) {
    inputs.lateral_specific_force_mps2 += static_cast<float>(noise(force_noise_mps2));
    inputs.vertical_specific_force_mps2 += static_cast<float>(noise(force_noise_mps2));
    inputs.roll_rate_radps += static_cast<float>(noise(rate_noise_radps));
    inputs.roll_angle_rad += static_cast<float>(noise(angle_noise_rad));
    inputs.yaw_rate_radps += static_cast<float>(noise(rate_noise_radps));
}

// Lateral acceleration of a lively drive: four incommensurate sines, +-7 m/s^2 at most.
inline double lively_lateral_acceleration_mps2(double time_s) {
    return 3.0 * std::sin(2.0 * pi * 0.11 * time_s) + 2.0 * std::sin(2.0 * pi * 0.37 * time_s + 0.5) +
           1.2 * std::sin(2.0 * pi * 0.83 * time_s + 1.1) + 0.8 * std::sin(2.0 * pi * 1.9 * time_s + 2.0);
}

// A vehicle that obeys (2) drives along; each call of next() gives what its sensors say, noise included.
class RecordedLikeDrive {
 public:
    RecordedLikeDrive(const rsi_parameters& parameters, const Deviation& deviation, std::uint64_t seed)
        : vehicle_(parameters, deviation), noise_(seed) {}

    rsi_inputs next() {
        GroundMotion motion;
        motion.lateral_acceleration_mps2 = lively_lateral_acceleration_mps2(time_s_);
        motion.roll_angle_rad = vehicle_.angle_rad();
        rsi_inputs inputs = sensed(motion);
        inputs.roll_rate_radps = static_cast<float>(
            vehicle_.rate_radps(motion.lateral_acceleration_mps2, gravity_mps2, motion.roll_angle_rad));
        add_noise(noise_, inputs);
        vehicle_.advance(motion.lateral_acceleration_mps2, gravity_mps2, 0.01);
        time_s_ += 0.01;
        return inputs;
    }

 private:
    RollPlaneVehicle vehicle_;
    Noise noise_;
    double time_s_{0.0};
};

}  // namespace rsi_test
