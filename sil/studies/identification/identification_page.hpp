// Identification page: an identification as a page to look into.
#pragma once

#include <string>

#include "sil/studies/identification/identification.hpp"

namespace sil {

// report.html: the values with their origin, what to know about them, and for every drive measured and fitted
// signals, those of fit.csv; a long drive has fewer points.
std::string identification_page(const Identification& result);

}  // namespace sil
