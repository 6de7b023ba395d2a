// Indicator level: every indicator on one scale, 0 without risk and 1 where it says "warn".
#pragma once

#include "rsi/types.hpp"

namespace rsi {

// The level of the indicator that `parameters` choose for the warning, 0 to 20, from outputs that have been
// computed. NaN where that indicator is not available.
float indicator_level(const Outputs& outputs, const Parameters& parameters);

}  // namespace rsi
