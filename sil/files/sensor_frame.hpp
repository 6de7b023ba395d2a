// Sensor frame: which frames on the bus are for the firmware.
#pragma once

#include <algorithm>

#include "application/sensor_reception.hpp"
#include "hal/interface/can_bus.hpp"

namespace sil {

inline bool is_sensor_frame(const hal::CanFrame& frame) {
    const auto& known = application::received_identifiers;
    return !frame.extended && std::find(known.begin(), known.end(), frame.identifier) != known.end();
}

}  // namespace sil
