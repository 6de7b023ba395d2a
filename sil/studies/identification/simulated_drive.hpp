// Simulated drive: what a recorder on board of a simulated vehicle writes.
#pragma once

#include <string>

#include "sil/simulation/mounted_sensors.hpp"
#include "sil/studies/drives/drive.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Drives the manoeuvre to its end. Sensors as `flaws` says, the IMU where the vehicle has it, wheel loads
// true.
Drive simulate_drive(const VehicleParameters& vehicle, const Manoeuvre& manoeuvre, const SensorFlaws& flaws,
                     const RunOptions& options = {});

// As a drive CSV (docs/drives.md).
std::string drive_csv(const Drive& drive);

}  // namespace sil
