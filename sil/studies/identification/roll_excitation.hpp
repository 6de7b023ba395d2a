// Roll excitation: whether the drives show the body's roll at all, and with the right signs.
#pragma once

#include <vector>

#include "sil/studies/identification/prepared_drive.hpp"

namespace sil {

// Throws IdentificationError with the drive and what to do.
void refuse_without_excitation(const std::vector<PreparedDrive>& ramps,
                               const std::vector<PreparedDrive>& dynamics);

}  // namespace sil
