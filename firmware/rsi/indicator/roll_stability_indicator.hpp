// Roll stability indicator: how much of the threshold is used up, equation (25) and its bank-free form.
#pragma once

#include "rsi/indicator/stability_threshold.hpp"

namespace rsi {

// (25): a_y / a_y*, 0 to 1. If a_y points away from the threshold's side (a bank steeper than the turn
// needs) it is 0; the printed |a_y| / |a_y*| would alarm there. If a_y* is not defined, the bank-free form
// takes its place.
float normalised_indicator(const Measurement& measured, const StabilityThreshold& threshold);

// |A/N| / T, 0 to 20: the same on a flat road, and independent of the bank angle.
float bank_free_indicator(const Measurement& measured, const StabilityThreshold& threshold);

// True once the CG stands outside the outer wheel's contact, |tan phi| >= c_w / (2 h), the static stability
// factor: the vehicle falls whatever the lateral acceleration, and neither indicator means anything.
bool has_overturned(const Measurement& measured, float static_stability_factor);

}  // namespace rsi
