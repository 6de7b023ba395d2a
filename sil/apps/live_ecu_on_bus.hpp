// Live ECU on a bus: one that runs by itself, behind a CAN interface.
#pragma once

#include <string>

#include "sil/live/live_ecu.hpp"

namespace sil {

// Throws std::runtime_error with a message for the user when there is no such interface.
std::unique_ptr<LiveEcu> live_ecu_on_bus(const std::string& interface);

}  // namespace sil
