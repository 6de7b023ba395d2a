// Parameter file: a vehicle's parameters from TOML.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// The message names file, line and key, says what is wrong and what to do.
class ParameterError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

// Every key must be there, with a finite number inside its range, and no other key. Keys are the field names
// of VehicleParameters. Throws ParameterError.
VehicleParameters load_vehicle(const std::filesystem::path& path);

}  // namespace sil
