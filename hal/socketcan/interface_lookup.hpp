// Interface lookup: number, kind and state of a network interface by its name.
#pragma once

#include <net/if.h>

#include <array>

namespace rsi::hal {

using InterfaceName = std::array<char, IFNAMSIZ>;  // ends in at least one zero

struct InterfaceLookup {
    int system_error{0};  // ENODEV when there is none of this name
    int index{0};
    bool is_can{false};
    bool is_up{false};
};

// Asks the kernel by route netlink. The older way, ioctl(SIOCGIFINDEX), makes the kernel start modprobe for
// an unknown name and wait for it, which takes up to a second; that would stall a loop that waits for its
// interface to come back.
InterfaceLookup look_up_interface(const InterfaceName& name) noexcept;

}  // namespace rsi::hal
