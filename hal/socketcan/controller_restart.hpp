// Controller restart: brings a CAN controller that is bus-off back to the bus.
#pragma once

#include <cstdint>

#include "hal/socketcan/interface_lookup.hpp"

namespace rsi::hal {

enum class ControllerRestart : std::uint8_t {
    done,            // the controller was restarted, or its interface taken down and up again
    not_bus_off,     // the kernel says that the controller is not bus-off
    left_to_kernel,  // the interface has a `restart-ms`, so the kernel restarts the controller by itself
    refused,         // system_error tells why; EPERM where the process lacks CAP_NET_ADMIN
};

struct ControllerRestartResult {
    ControllerRestart outcome{ControllerRestart::refused};
    int system_error{0};
};

// As `ip link set NAME type can restart` does. A driver that cannot restart its controller (slcan) gets its
// interface taken down and up instead, which every socket on the interface notices as ENETDOWN.
// Lasts as long as the driver needs for it.
ControllerRestartResult restart_controller(const InterfaceName& name) noexcept;

}  // namespace rsi::hal
