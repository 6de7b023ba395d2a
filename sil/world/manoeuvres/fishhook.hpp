// Fishhook: NHTSA's, with a speed and a handwheel angle of the caller's.
#pragma once

#include <cstdint>

#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {

// The reversal begins a fixed time after the first ramp (1a), or when the body has stopped rolling (1b).
enum class FishhookReversal : std::uint8_t { after_a_fixed_dwell, at_small_roll_rate };

// Factor on the handwheel angle that gives 0.3 g.
inline constexpr double fishhook_amplitude_factor = 6.5;

Manoeuvre fishhook(FishhookReversal reversal, double speed_mps, double amplitude_rad);

}  // namespace sil
