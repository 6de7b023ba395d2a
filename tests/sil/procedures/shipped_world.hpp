// Shipped world: a vehicle of the project with its calibration, and what the tests of procedures share.
#pragma once

#include <string>

#include "sil/files/calibration_file.hpp"
#include "sil/studies/procedures/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace testing_procedures {

inline sil::ProcedureWorld shipped(const std::string& name) {
    const std::string project = RSI_SOURCE_DIR;
    sil::ProcedureWorld world;
    world.vehicle = sil::load_vehicle(project + "/sil/vehicles/" + name + ".toml");
    world.calibration = sil::load_calibration(project + "/firmware/calibrations/" + name + ".toml");
    return world;
}

// Without what tells left from right: the Panhard rod's path is straight up and down, and the IMU is in the
// middle.
inline sil::ProcedureWorld symmetric(sil::ProcedureWorld world) {
    world.vehicle.rear_suspension.panhard_slope = 0.0;
    world.vehicle.rear_suspension.panhard_length_m = 1.0e12;
    world.vehicle.imu_mount.y_m = 0.0;
    world.calibration.imu_y_m = 0.0F;
    return world;
}

inline sil::Criterion criterion(sil::Bound bound, double limit, const std::optional<double>& value) {
    return {{"key", "name", "unit", 1, value}, bound, limit, "source"};
}

}  // namespace testing_procedures
