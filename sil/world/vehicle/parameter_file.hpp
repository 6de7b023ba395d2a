// Parameter file: a vehicle's parameters from TOML.
#pragma once

#include <filesystem>

#include "sil/input_error.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Every key must be there, with a finite number inside its range, and no other key; only lag and compliance
// of the steering may be left out, and are 0 then. Keys are the field names of VehicleParameters. Throws
// InputError.
VehicleParameters load_vehicle(const std::filesystem::path& path);

}  // namespace sil
