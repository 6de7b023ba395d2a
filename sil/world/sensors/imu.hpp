// Imu: the inertial sensor, fixed to the body at any point of it.
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
    bool averaged_;
    SensorChannel lateral_;
    SensorChannel vertical_;
    SensorChannel roll_rate_;

    double lateral_sum_mps2_{0.0};
    double vertical_sum_mps2_{0.0};
    double roll_rate_sum_radps_{0.0};
    int observed_{0};
};

}  // namespace sil
