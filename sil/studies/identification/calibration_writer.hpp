// Calibration writer: a complete calibration file from what was identified.
#pragma once

#include <string>
#include <vector>

#include "sil/studies/identification/identification.hpp"

namespace sil {

// The text of firmware/calibrations/large_suv.toml with this vehicle's values, each with its origin as a
// comment. All that does not depend on the vehicle, the warning above all, stays as it is there. Doubts
// about the identification stand at the head.
std::string calibration_text(const Identification& result);

// These doubts, of a calibration's text.
std::vector<std::string> doubts_in(const std::string& calibration);

// As it stands there: a number, or the name of a choice between quotation marks.
std::string value_text(const IdentifiedValue& value);

}  // namespace sil
