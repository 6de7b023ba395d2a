// Interface lookup by an RTM_GETLINK request.
#include "hal/socketcan/interface_lookup.hpp"

#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if_arp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace hal {
namespace {

struct Request {
    nlmsghdr header{};
    ifinfomsg link{};
    rtattr name_attribute{};
    InterfaceName name{};
};
static_assert(sizeof(Request) == NLMSG_LENGTH(sizeof(ifinfomsg)) + RTA_LENGTH(IFNAMSIZ),
              "no padding in between");

// What follows the header of an answer, of which only the beginning is of interest.
union Answer {
    nlmsgerr error;
    ifinfomsg link;
};

struct Message {
    nlmsghdr header{};
    Answer answer{};
};

int exchange(int descriptor, const Request& request, Message& message) noexcept {
    // The kernel answers while it takes the request, so that the answer waits when send() returns.
    if (send(descriptor, &request, sizeof(request), 0) < 0) {
        return errno;
    }
    const ssize_t bytes = recv(descriptor, &message, sizeof(message), MSG_DONTWAIT);
    if (bytes < 0) {
        return errno;
    }
    if (static_cast<std::size_t>(bytes) < sizeof(nlmsghdr) + sizeof(ifinfomsg)) {
        return EPROTO;
    }
    return message.header.nlmsg_type == NLMSG_ERROR ? -message.answer.error.error : 0;
}

}  // namespace

InterfaceLookup look_up_interface(const InterfaceName& name) noexcept {
    InterfaceLookup result;
    const int descriptor = socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE);
    if (descriptor < 0) {
        result.system_error = errno;
        return result;
    }
    Request request;
    request.header.nlmsg_len = sizeof(request);
    request.header.nlmsg_type = RTM_GETLINK;
    request.header.nlmsg_flags = NLM_F_REQUEST;
    request.name_attribute.rta_type = IFLA_IFNAME;
    request.name_attribute.rta_len = RTA_LENGTH(IFNAMSIZ);
    request.name = name;

    Message message;
    result.system_error = exchange(descriptor, request, message);
    close(descriptor);
    if (result.system_error == 0) {
        result.index = message.answer.link.ifi_index;
        result.is_can = message.answer.link.ifi_type == ARPHRD_CAN;
        result.is_up = (message.answer.link.ifi_flags & IFF_UP) != 0U;
    }
    return result;
}

}  // namespace hal
