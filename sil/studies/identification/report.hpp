// Report: the result of an identification for a reader, and its signals for pictures.
#pragma once

#include <string>

#include "sil/studies/identification/identification.hpp"

namespace sil {

// Values with standard errors, residuals of every drive, warnings.
std::string identification_report(const Identification& result);

// One row a sample: measured and fitted moments, residuals, load moments, lateral acceleration asked for by
// the steering. Drives one after the other.
std::string fit_csv(const Identification& result);

// The stiffness curve: roll angle in degrees, moment, moment of the linear part.
std::string curve_csv(const Identification& result);

// Names and numbers that the pictures show, as gnuplot definitions.
std::string fit_marks(const Identification& result);

}  // namespace sil
