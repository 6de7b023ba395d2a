// Sensor quality: how noisy and how coarse the sensors of the drives are, as far as the monitoring has to
// know.
#pragma once

#include <vector>

#include "sil/studies/drives/drive.hpp"

namespace sil {

struct SensorQuality {
    // rms of the noise of the noisier accelerometer in the noisiest drive; 0 where it is as small as behind a
    // low-pass filter.
    double accelerometer_noise_mps2{0.0};
    // The smallest step of the speed's value; 0 where it is finer than what the monitoring takes for fine, or
    // where the speed hardly changes.
    double speed_resolution_mps{0.0};
};

SensorQuality sensor_quality(const std::vector<Drive>& ramps, const std::vector<Drive>& dynamics);

}  // namespace sil
