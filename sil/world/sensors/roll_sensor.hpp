// RollSensor: the angle of the body against the road or the horizon, and the road's bank where the car can
// measure it.
#pragma once

#include <cstdint>

#include "sil/world/sensors/sensor_channel.hpp"
#include "sil/world/sensors/sensor_options.hpp"
#include "sil/world/sensors/sensor_sample.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

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

}  // namespace sil
