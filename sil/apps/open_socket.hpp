// Open socket: a CAN interface for the world, and whether an ECU is on it.
#pragma once

#include <string>

#include "hal/socketcan/socket_can_bus.hpp"

namespace sil {

// All throw std::runtime_error with a message for the user.
void open_or_throw(rsi::hal::SocketCanBus& socket, const std::string& interface);

// That there is such an interface.
void check_interface(const std::string& interface);

// Whether an ECU sends its status frame within `longest`.
bool hears_ecu(rsi::hal::SocketCanBus& socket, rsi::hal::Time longest);

// That an ECU sends by itself.
void expect_ecu(rsi::hal::SocketCanBus& socket, const std::string& interface);

}  // namespace sil
