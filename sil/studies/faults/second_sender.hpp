// Second sender: frames that another node sends with an identifier of the bus, protected as the genuine ones
// are.
#pragma once

#include <cstdint>

#include "hal/interface/can_bus.hpp"
#include "sil/studies/faults/fault.hpp"

namespace sil {

// Identifier of a sensor frame, or of the ECU's warning. Its content depends on the sign of `magnitude`.
// Negative: calm, a vehicle that goes straight ahead at 100 km/h, and `ready`. Else: alarming, one that is
// about to roll over to the right, and `warning`.
hal::CanFrame second_senders_frame(FaultPlace place, double magnitude, std::uint8_t counter);

}  // namespace sil
