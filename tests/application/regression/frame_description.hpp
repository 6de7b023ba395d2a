// Frame description: what a frame says, for people.
#pragma once

#include <string>

#include "rsi/hal/can_bus.hpp"

namespace sil {

// "RolloverWarning State=warning Side=right WarningLevel=1 LateralAcceleration=7.105 m/s^2 ..."; a
// signal that is not valid shows why. Empty for a frame that the DBC file does not define or whose length is
// another.
std::string describe_frame(const rsi::hal::CanFrame& frame);

}  // namespace sil
