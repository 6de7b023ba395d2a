// Mirror: the same truth with left and right exchanged.
#pragma once

#include "sil/world/vehicle/truth.hpp"

namespace sil {

Truth mirrored(const Truth& truth);

}  // namespace sil
