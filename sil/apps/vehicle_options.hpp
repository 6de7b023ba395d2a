// Vehicle options: which vehicle a study simulates, and how the firmware is calibrated in it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sil {

struct VehicleFiles {
    std::string vehicle{};
    std::string calibration{};
};

// --vehicle and --parameters; both must be there.
void add_vehicle_options(CLI::App& command, VehicleFiles& files);

}  // namespace sil
