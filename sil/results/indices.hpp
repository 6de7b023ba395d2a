// Indices that need wheel loads, or the true motion: what only a simulation knows.
#pragma once

#include "sil/world/vehicle/truth.hpp"

namespace sil {

enum class Axle { front, rear };

// (26): (F_zR - F_zL)/(F_zR + F_zL) over both axles, -1 to 1, > 0 in a left turn. NaN while no wheel touches
// the road. 1 or -1 is lift-off on two wheels of one side (the paper's TWLO).
double true_load_transfer_ratio(const Truth& truth);

// The same on one axle. 1 or -1 is lift-off of one wheel of this axle (the paper's OWLO).
double true_load_transfer_ratio(const Truth& truth, Axle axle);

}  // namespace sil
