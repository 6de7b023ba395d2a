// Indicator level: every indicator on one scale, 0 without risk and 1 where it says "warn".
#pragma once

#include "rsi/types.hpp"

namespace rsi {

// The level of the indicator that `parameters` choose for the warning, 0 to 20, from outputs that have been
// computed. NaN where that indicator is not available.
float indicator_level(const Outputs& outputs, const Parameters& parameters);

// The side that this indicator speaks of: +1 for a left turn (the vehicle would fall to the right), -1 for a
// right turn. An indicator with a sign has its own; a predicted one that of the predicted load transfer, not
// of the present force; one of roll angle and rate alone that of `roll_angle_rad`.
float indicator_side(const Outputs& outputs, const Parameters& parameters, float roll_angle_rad);

}  // namespace rsi
