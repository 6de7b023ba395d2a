// SensorSuite: hands the truth to each sensor.
#include "sil/world/sensors/sensor_suite.hpp"

namespace sil {

SensorSuite::SensorSuite(const SensorOptions& options)
    : imu_(options.imu, options.seed),
      roll_(options.roll, options.seed),
      motion_(options.motion, options.seed) {}

void SensorSuite::observe(const Truth& truth) {
    imu_.observe(truth);
}

SensorSample SensorSuite::report(const Truth& truth) {
    SensorSample sample;
    sample.time_s = truth.time_s;
    imu_.report(sample);
    roll_.report(truth, sample);
    motion_.report(truth, sample);
    return sample;
}

}  // namespace sil
