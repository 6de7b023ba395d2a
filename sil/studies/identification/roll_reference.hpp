// Roll reference: whether a drive's roll angle is one against gravity in place of one against the road.
#pragma once

#include <optional>
#include <string>

#include "sil/studies/identification/prepared_drive.hpp"
#include "sil/studies/identification/roll_fit.hpp"

namespace sil {

// What speaks for it, in words; nothing on a level road, where both angles are the same.
std::optional<std::string> roll_reference_doubt(const VehicleData& vehicle, const RollFit& roll,
                                                const PreparedDrive& drive);

}  // namespace sil
