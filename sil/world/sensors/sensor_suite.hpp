// Sensor suite: the sensors of the car, from the truth to the sample that goes on the bus.
#pragma once

#include <array>
#include <cstdint>

#include "sil/world/sensors/sensor_channel.hpp"
#include "sil/world/sensors/sensor_options.hpp"
#include "sil/world/sensors/sensor_sample.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

// Specific force at the mounting point r of a rigid body, in body components (m/s^2):
// f = f_cg + alpha x r + omega x (omega x r). Nothing but kinematics; exact at any angle and rate.
std::array<double, 3> specific_force_at(const Truth& truth, const MountingPosition& position);

// Reports the mean of what it has observed since its last report, as an automotive IMU's decimation filter
// does; one without such a filter reports the latest. Fed every 1 ms and read every 10 ms, the mean is a
// delay of 4.5 ms against the latest truth.
class Imu {
 public:
    Imu(const ImuOptions& options, std::uint64_t seed);

    // Takes in one truth; to be called at the step of the simulation.
    void observe(const Truth& truth);

    // Writes accelerations and roll rate and begins a new mean. Not available (NaN) if nothing was observed.
    void report(SensorSample& sample);

 private:
    MountingPosition position_;
    bool tilted_;
    std::array<std::array<double, 3>, 3> axes_;  // of the housing, in body components
    bool averaged_;
    SensorChannel lateral_;
    SensorChannel vertical_;
    SensorChannel roll_rate_;

    double lateral_sum_mps2_{0.0};
    double vertical_sum_mps2_{0.0};
    double roll_rate_sum_radps_{0.0};
    int observed_{0};
};

// The angle of the body against the road or the horizon, and the road's bank where the car can measure it.
class RollSensor {
 public:
    RollSensor(const RollSensorOptions& options, std::uint64_t seed);

    // Writes the roll angle as it is at this instant, and the bank or "not available" (NaN).
    void report(const Truth& truth, SensorSample& sample);

 private:
    RollReference reference_;
    bool reports_bank_;
    SensorChannel roll_angle_;
    SensorChannel bank_angle_;
};

// Speed, yaw rate and steering wheel angle, as a car's gateway offers them.
class VehicleMotionSensor {
 public:
    VehicleMotionSensor(const VehicleMotionOptions& options, std::uint64_t seed);

    // Writes the values of this instant. Speed comes from wheel speeds and so has no sign: it ends at zero.
    // The yaw rate is that about the body's own z axis, which is where the gyro is mounted.
    void report(const Truth& truth, SensorSample& sample);

 private:
    SensorChannel speed_;
    SensorChannel yaw_rate_;
    SensorChannel steering_wheel_angle_;
};

// All sensors of the car together.
class SensorSuite {
 public:
    explicit SensorSuite(const SensorOptions& options);

    // To be called at every step of the simulation (1 ms).
    void observe(const Truth& truth);

    // To be called at every bus cycle (10 ms), after observe() of the same truth: the IMU's mean since the
    // last report, everything else as it is now. The sample bears the truth's time.
    SensorSample report(const Truth& truth);

 private:
    Imu imu_;
    RollSensor roll_;
    VehicleMotionSensor motion_;
    MassSensorOptions mass_;
};

}  // namespace sil
