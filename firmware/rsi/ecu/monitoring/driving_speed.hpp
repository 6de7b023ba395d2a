// Driving speed: from which on a vehicle drives forwards, and yaw rate times speed shows its turn.
#pragma once

namespace rsi::monitoring {

// The speed has no sign, and below it the vehicle may be rolling backwards.
inline constexpr float driving_speed_mps = 5.0F;

}  // namespace rsi::monitoring
