// SensorSuite: hands the truth to each sensor.
#include "sil/world/sensors/sensor_suite.hpp"

namespace sil {

SensorSuite::SensorSuite(const SensorOptions& options)
    : imu_(options.imu, options.seed),
      roll_(options.roll, options.seed),
      motion_(options.motion, options.seed),
      mass_(options.mass) {}

void SensorSuite::observe(const Truth& truth) {
    imu_.observe(truth);
}

SensorSample SensorSuite::report(const Truth& truth) {
    SensorSample sample;
    sample.time_s = truth.time_s;
    imu_.report(sample);
    roll_.report(truth, sample);
    motion_.report(truth, sample);
    if (mass_.fitted) {
        sample.vehicle_mass_kg = truth.mass_kg * (1.0 + mass_.scale_error);
    }
    return sample;
}

}  // namespace sil
