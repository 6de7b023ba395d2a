#include "sil/apps/vehicle_options.hpp"

namespace sil {

void add_vehicle_options(CLI::App& command, VehicleFiles& files) {
    command.add_option("--vehicle", files.vehicle, "Parameter file of the simulated vehicle (TOML)")
        ->required();
    command.add_option("--parameters", files.calibration, "Calibration of the firmware (TOML)")->required();
}

}  // namespace sil
