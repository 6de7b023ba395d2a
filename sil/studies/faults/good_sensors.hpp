// Good sensors: kinds of sensors that a vehicle may well have, and that must not be taken for faulty.
#pragma once

#include <string>
#include <vector>

#include "sil/world/sensors/sensor_options.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

struct GoodSensors {
    std::string name{};
    SensorOptions options{};
};

// Slow ones, coarse ones, late ones, and accelerometers without a filter.
std::vector<GoodSensors> good_sensors(const VehicleParameters& vehicle);

}  // namespace sil
