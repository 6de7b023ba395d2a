#include "sil/studies/faults/good_sensors.hpp"

#include <fmt/format.h>

#include <functional>
#include <limits>

#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double half_degree = 0.5 / degrees_per_radian;
constexpr double one_kmh = 1.0 / 3.6;
constexpr double finest_unchecked_mps = 0.05;  // up to it a speed that repeats its value may be stuck
constexpr double raw_noise_mps2 = 1.0;  // rms, of an accelerometer without a filter in a vehicle that drives

using Change = std::function<void(SensorOptions&)>;
using Calibration = std::function<void(rsi::Parameters&)>;
using Channels = std::vector<ChannelOptions*>;

Channels imu_channels(SensorOptions& options) {
    return {&options.imu.lateral_acceleration_mps2, &options.imu.vertical_acceleration_mps2,
            &options.imu.roll_rate_radps};
}

Channels roll_channels(SensorOptions& options) {
    return {&options.roll.roll_angle_rad, &options.roll.bank_angle_rad};
}

Channels motion_channels(SensorOptions& options) {
    return {&options.motion.speed_mps, &options.motion.yaw_rate_radps,
            &options.motion.steering_wheel_angle_rad};
}

Channels all_channels(SensorOptions& options) {
    Channels all = imu_channels(options);
    for (const Channels& more : {roll_channels(options), motion_channels(options)}) {
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

void coarse_angle(SensorOptions& options) {
    options.roll.roll_angle_rad.quantisation_step = half_degree;
}

void coarse_rates(SensorOptions& options) {
    options.imu.roll_rate_radps.quantisation_step = half_degree;
    options.motion.yaw_rate_radps.quantisation_step = half_degree;
}

void leave_out(const Channels& channels) {
    for (ChannelOptions* const channel : channels) {
        channel->bias = std::numeric_limits<double>::quiet_NaN();
    }
}

void without_roll_sensor(SensorOptions& options) {
    leave_out(roll_channels(options));
}

void without_motion(SensorOptions& options) {
    leave_out(motion_channels(options));
}

void without_steering(SensorOptions& options) {
    leave_out({&options.motion.steering_wheel_angle_rad});
}

void coarse_speed(SensorOptions& options) {
    options.motion.speed_mps.quantisation_step = one_kmh;
}

void fine_speed(SensorOptions& options) {
    options.motion.speed_mps.quantisation_step = finest_unchecked_mps;
}

void all_coarse(SensorOptions& options) {
    coarse_angle(options);
    coarse_rates(options);
    coarse_speed(options);
}

void at_50_hz(SensorOptions& options) {
    for (ChannelOptions* const channel : all_channels(options)) {
        channel->reports_a_value = 2U;
    }
}

void raw_accelerometers(SensorOptions& options) {
    options.imu.averaged = false;
    options.imu.lateral_acceleration_mps2.noise_rms = raw_noise_mps2;
    options.imu.vertical_acceleration_mps2.noise_rms = raw_noise_mps2;
}

Change late(Channels (*channels)(SensorOptions&), unsigned cycles) {
    return [channels, cycles](SensorOptions& options) {
        for (ChannelOptions* const channel : channels(options)) {
            channel->reports_late = cycles;
        }
    };
}

struct Kind {
    std::string name;
    Change change;
    Calibration calibrate{};  // empty: as for the usual sensors
};

void with_coarse_speed(rsi::Parameters& calibration) {
    calibration.speed_resolution_mps = static_cast<float>(one_kmh);
}

void with_raw_accelerometers(rsi::Parameters& calibration) {
    calibration.accelerometer_noise_mps2 = static_cast<float>(raw_noise_mps2);
}

std::vector<Kind> all_kinds() {
    std::vector<Kind> kinds{
        {"all at 50 Hz", at_50_hz},
        {"roll angle in steps of 0.5 deg", coarse_angle},
        {"roll and yaw rate in steps of 0.5 deg/s", coarse_rates},
        {"speed in steps of 0.05 m/s", fine_speed},
        {"speed in steps of 1 km/h", coarse_speed, with_coarse_speed},
        {"all of these steps", all_coarse, with_coarse_speed},
        {"accelerometers without a filter, noise of 1 m/s^2 rms", raw_accelerometers,
         with_raw_accelerometers},
        {"no roll sensor", without_roll_sensor,
         [](rsi::Parameters& one) { one.roll_angle_sensor = RSI_ROLL_SENSOR_NOT_FITTED; }},
        {"no steering", without_steering,
         [](rsi::Parameters& one) { one.vehicle_motion_sensors = RSI_MOTION_WITHOUT_STEERING; }},
        {"no speed, yaw rate and steering", without_motion,
         [](rsi::Parameters& one) { one.vehicle_motion_sensors = RSI_MOTION_NOT_FITTED; }}};
    for (const unsigned cycles : {2U, 4U, 8U}) {
        const unsigned ms = 10U * cycles;
        kinds.push_back({fmt::format("Imu {} ms late", ms), late(imu_channels, cycles)});
        kinds.push_back({fmt::format("RollAngle {} ms late", ms), late(roll_channels, cycles)});
        kinds.push_back({fmt::format("VehicleMotion {} ms late", ms), late(motion_channels, cycles)});
        kinds.push_back({fmt::format("all {} ms late", ms), late(all_channels, cycles)});
    }
    return kinds;
}

}  // namespace

std::vector<GoodSensors> good_sensors(const SensorOptions& usual, const rsi::Parameters& calibration) {
    std::vector<GoodSensors> all;
    for (const Kind& kind : all_kinds()) {
        all.push_back({kind.name, usual, calibration});
        kind.change(all.back().options);
        if (kind.calibrate) {
            kind.calibrate(all.back().calibration);
        }
    }
    return all;
}

}  // namespace sil
