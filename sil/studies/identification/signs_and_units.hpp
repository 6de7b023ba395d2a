// Signs and units: what in a drive contradicts itself unless a column has a wrong sign or a wrong unit.
#pragma once

#include "sil/studies/identification/drive_signals.hpp"

namespace sil {

// Throws IdentificationError with the drive, the column and what to do. Only what comes before a wheel lifts
// is looked at; nothing is cut, because a wrong unit would cut the drive at the wrong place.
void refuse_wrong_signs_and_units(const Drive& drive, const Cycles& cycles, double filter_lag_s);

}  // namespace sil
