// Sensor frame: which frames on the bus are for the firmware.
#pragma once

#include <algorithm>

#include "rsi/ecu/application/sensor_reception.hpp"
#include "rsi/hal/can_bus.hpp"

namespace sil {

inline bool is_sensor_frame(const rsi::hal::CanFrame& frame) {
    const auto& known = rsi::application::received_identifiers;
    return !frame.extended && std::find(known.begin(), known.end(), frame.identifier) != known.end();
}

}  // namespace sil
