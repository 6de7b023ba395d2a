// Learning drive: ordinary driving before a run, from which the component learns what the vehicle carries.
#pragma once

#include <vector>

#include "rsi/types.hpp"
#include "sil/world/sensors/sensor_options.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Inputs of the firmware from the vehicle's sensors in `duration_s` of ordinary driving at up to 80 km/h. No
// turn takes more than half of what would tip a rigid vehicle, nor more than 0.4 g.
std::vector<rsi::Inputs> learning_drive(const VehicleParameters& vehicle, const SensorOptions& sensors,
                                        const rsi::Parameters& calibration, double duration_s);

// Load that the component learns from it if the vehicle's mass is wrong by the share `mass_sensor_error`.
// Throws std::invalid_argument with the field's name when the calibration is refused.
rsi::LearntLoad learnt_load(const std::vector<rsi::Inputs>& drive, const rsi::Parameters& calibration,
                            double mass_sensor_error = 0.0);

}  // namespace sil
