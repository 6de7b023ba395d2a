// SensorOptions: the preset of ordinary automotive sensors.
#include "sil/world/sensors/sensor_options.hpp"
#include "sil/random.hpp"
#include "sil/units.hpp"
#include "sil/world/sensors/sensor_channel.hpp"

namespace sil {
namespace {

constexpr double rad_per_deg = 3.14159265358979323846 / 180.0;
constexpr double mps_per_kmph = 1.0 / 3.6;

constexpr double acceleration_noise_g = 0.02;
constexpr double rate_noise_degps = 0.3;
constexpr double angle_noise_deg = 0.2;
constexpr double speed_noise_kmph = 0.1;
constexpr double steering_noise_deg = 0.1;
constexpr auto mass_stream = static_cast<std::uint64_t>(NoiseStream::vehicle_mass);

double bias_g(AccelerometerBias bias) {
    switch (bias) {
        case AccelerometerBias::after_zeroing:
            return 0.005;
        case AccelerometerBias::raw:
            return 0.03;
        case AccelerometerBias::none:
            break;
    }
    return 0.0;
}

}  // namespace

SensorOptions noisy_sensors(std::uint64_t seed, AccelerometerBias bias) {
    SensorOptions options;
    options.seed = seed;

    const ChannelOptions acceleration{acceleration_noise_g * g_mps2, bias_g(bias) * g_mps2, 0.0};
    options.imu.lateral_acceleration_mps2 = acceleration;
    options.imu.vertical_acceleration_mps2 = acceleration;
    options.imu.roll_rate_radps.noise_rms = rate_noise_degps * rad_per_deg;

    options.roll.roll_angle_rad.noise_rms = angle_noise_deg * rad_per_deg;
    options.roll.bank_angle_rad.noise_rms = angle_noise_deg * rad_per_deg;

    options.motion.speed_mps.noise_rms = speed_noise_kmph * mps_per_kmph;
    options.motion.yaw_rate_radps.noise_rms = rate_noise_degps * rad_per_deg;
    options.motion.steering_wheel_angle_rad.noise_rms = steering_noise_deg * rad_per_deg;

    options.mass.scale_error =
        mass_sensor_accuracy * (2.0 * unit_interval(scrambled(scrambled(seed) ^ mass_stream)) - 1.0);
    return options;
}

}  // namespace sil
