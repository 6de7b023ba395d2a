// Admitted range: what the component admits of a value, less a reserve for later corrections of it.
#pragma once

#include "rsi/parameters.hpp"

namespace sil {

// A value may be corrected by so much, up or down, and the component still admits it.
inline constexpr double correction_reserve = 0.2;
inline constexpr const char* outside_admitted =
    "beyond what the component admits after a correction of 20 %: the nearest";

// The nearest value that stays within the range of this field when it is corrected by correction_reserve.
double within_admitted(float rsi::Parameters::* field, double value);

}  // namespace sil
