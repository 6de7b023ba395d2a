// Driving speed: lower limit for checks that use yaw rate times speed as lateral acceleration.
#pragma once

namespace rsi::monitoring {

// The speed signal is unsigned: below this limit the vehicle may be rolling backwards.
inline constexpr float driving_speed_mps = 5.0F;

}  // namespace rsi::monitoring
