// Calibration default: what the written calibration has where nothing is identified.
#pragma once

#include <string_view>

namespace sil {

// The key that a line of a calibration gives a value to; empty where it gives none.
std::string_view key_in(std::string_view line);

// Throws std::logic_error for a key that the template does not have.
double calibration_default(std::string_view key);

}  // namespace sil
