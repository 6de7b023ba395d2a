// Route netlink: one question to the kernel about its network interfaces, and its answer.
#pragma once

#include <linux/netlink.h>
#include <linux/rtnetlink.h>

namespace rsi::hal {

// Body of an answer, of which only the beginning is of interest.
union RouteAnswer {
    nlmsgerr error;
    ifinfomsg link;
};

// Sends the message that `request` begins, of request.nlmsg_len bytes, and takes the kernel's first answer.
// Returns 0, or the errno of what went wrong, be it here or in the kernel. The kernel answers while it takes
// the message: the call lasts as long as the kernel's work, and waits for nothing else but the kernel's lock
// on its interfaces.
int ask_route(const nlmsghdr& request, RouteAnswer& answer) noexcept;

}  // namespace rsi::hal
