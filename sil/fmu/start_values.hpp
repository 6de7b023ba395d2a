// Start values: what `sil/fmu/build` writes for each FMU, of the files that it was given.
#pragma once

#include <cstddef>

namespace fmu {

// As modelDescription.xml has it, as instantiationToken or guid.
extern const char* const instantiation_token;

// Of the parameters, in the order of their rows.
extern const double start_values[];
extern const std::size_t start_value_count;

}  // namespace fmu
