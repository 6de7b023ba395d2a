// Calibrated vehicle: what `identify` alone makes of two noisy drives and a data sheet.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sil/studies/drives/drive.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// The slow ramp and the step steer of `rsi-sil identify --simulate`, with noise, the step gentle enough for
// the vehicle.
struct IdentificationDrives {
    std::vector<Drive> ramps;
    std::vector<Drive> dynamics;
    double largest_ramp_ltr{0.0};  // by the wheel loads

    IdentificationDrives without_loads() const;
};

// On the ramp the driver turns back at a load transfer ratio of `back_from_ltr`.
IdentificationDrives identification_drives(const VehicleParameters& vehicle, double back_from_ltr,
                                           std::uint64_t sensor_seed);

struct Calibrated {
    std::string failure{};  // why there is no calibration; empty when there is one
    std::vector<std::string> warnings{};
};

// Writes `calibration`, or, where the component refuses what was fitted, the same with the ending
// .refused.toml. Any error becomes the failure's text.
Calibrated calibrate(const std::filesystem::path& vehicle_data, const IdentificationDrives& drives,
                     const std::filesystem::path& calibration);

}  // namespace sil
