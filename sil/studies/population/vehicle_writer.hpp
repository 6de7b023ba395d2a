// Vehicle writer: a drawn vehicle as the files that a user of the project would have of it.
#pragma once

#include <string>
#include <string_view>

#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Text that load_vehicle reads back, the same to the last bit. `remark` heads it, a comment without its sign.
std::string vehicle_toml(const VehicleParameters& vehicle, std::string_view remark);

// Data sheet and workshop values, for load_vehicle_data: masses, heights and lengths as they are.
std::string vehicle_data_toml(const VehicleParameters& vehicle);

}  // namespace sil
