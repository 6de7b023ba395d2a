// Mirror: the same truth, and the same disturbance, with left and right exchanged.
#pragma once

#include "sil/world/vehicle/disturbance.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

Truth mirrored(const Truth& truth);
Disturbance mirrored(const Disturbance& disturbance);

}  // namespace sil
