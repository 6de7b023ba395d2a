// Start values: what `sil/exchange/fmu/build` writes for each FMU, of the files that it was given.
#pragma once

namespace fmu {

// As modelDescription.xml has it, as instantiationToken or guid.
extern const char* const instantiation_token;

// Values of the parameters, in the order of their rows.
extern const double start_values[];

}  // namespace fmu
