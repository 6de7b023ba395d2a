// Roll reference: what a drive's roll angle is measured against, road or horizon.
#pragma once

#include <optional>
#include <string>

#include "sil/studies/identification/prepared_drive.hpp"
#include "sil/studies/identification/roll_fit.hpp"

namespace sil {

struct SeenRollReference {
    RollReference reference;
    std::string by;  // the evidence, in words
};

// Nothing on a level road, where both angles are the same. `roll` is that of level drives, as far as there
// are any.
std::optional<SeenRollReference> seen_roll_reference(const VehicleData& vehicle, const RollFit& roll,
                                                     const PreparedDrive& drive);

}  // namespace sil
