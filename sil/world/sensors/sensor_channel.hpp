// SensorChannel: one measured quantity with its bias, noise, quantisation, delay and rate.
#pragma once

#include <cstdint>
#include <deque>

#include "sil/world/sensors/noise_source.hpp"
#include "sil/world/sensors/sensor_options.hpp"

namespace sil {

// Every channel has a noise stream of its own; the numbers are part of the reproducible result.
enum class NoiseStream : std::uint64_t {
    lateral_acceleration = 1,
    vertical_acceleration = 2,
    roll_rate = 3,
    roll_angle = 4,
    bank_angle = 5,
    speed = 6,
    yaw_rate = 7,
    steering_wheel_angle = 8,
    vehicle_mass = 9,
};

class SensorChannel {
 public:
    SensorChannel(const ChannelOptions& options, std::uint64_t seed, NoiseStream stream);

    // The value that the sensor reports for this true one. Draws noise once a call. A late sensor says what
    // it first measured until that is as old as it must be.
    double measure(double true_value);

 private:
    double disturbed(double true_value);

    ChannelOptions options_;
    NoiseSource noise_;
    std::deque<double> under_way_{};
    double held_{0.0};
    unsigned reports_of_held_{0U};
};

}  // namespace sil
