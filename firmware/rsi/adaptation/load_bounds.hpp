// Load bounds: range of a learnt load, for learning and for its check.
#pragma once

namespace rsi {

// x, the share by which m_s H is larger than calibrated.
inline constexpr float least_load_excess = -0.45F;  // of a truck that has been emptied
inline constexpr float largest_load_excess = 1.0F;
// Its standard deviation before anything is learnt: cars carry up to a fifth more m_s H, trucks twice it.
inline constexpr float largest_load_excess_deviation = 0.25F;

}  // namespace rsi
