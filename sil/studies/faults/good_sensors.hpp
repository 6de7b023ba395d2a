// Good sensors: kinds of sensors that a vehicle may well have, and that must not be taken for faulty.
#pragma once

#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/world/sensors/sensor_options.hpp"

namespace sil {

struct GoodSensors {
    std::string name{};
    SensorOptions options{};
    rsi::Parameters calibration{};  // as it says which sensors the vehicle has
};

// Variants of these usual ones: slow, coarse and late ones, accelerometers without a filter, and vehicles
// that lack some.
std::vector<GoodSensors> good_sensors(const SensorOptions& usual, const rsi::Parameters& calibration);

}  // namespace sil
