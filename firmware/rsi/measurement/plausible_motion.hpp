// Plausible motion: what no vehicle exceeds. A value beyond it is none, wherever the component takes one.
#pragma once

namespace rsi {

inline constexpr float largest_plausible_rate_radps = 10.0F;  // of roll and yaw
inline constexpr float largest_plausible_speed_mps = 150.0F;

}  // namespace rsi
