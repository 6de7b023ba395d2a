// Interface lookup by an RTM_GETLINK request.
#include "hal/socketcan/interface_lookup.hpp"

#include <net/if_arp.h>

#include "hal/socketcan/route_netlink.hpp"

namespace rsi::hal {
namespace {

struct Request {
    nlmsghdr header{};
    ifinfomsg link{};
    rtattr name_attribute{};
    InterfaceName name{};
};
static_assert(sizeof(Request) == NLMSG_LENGTH(sizeof(ifinfomsg)) + RTA_LENGTH(IFNAMSIZ),
              "no padding in between");

}  // namespace

InterfaceLookup look_up_interface(const InterfaceName& name) noexcept {
    Request request;
    request.header.nlmsg_len = sizeof(request);
    request.header.nlmsg_type = RTM_GETLINK;
    request.header.nlmsg_flags = NLM_F_REQUEST;
    request.name_attribute.rta_type = IFLA_IFNAME;
    request.name_attribute.rta_len = RTA_LENGTH(IFNAMSIZ);
    request.name = name;

    InterfaceLookup result;
    RouteAnswer answer{};
    result.system_error = ask_route(request.header, answer);
    if (result.system_error == 0) {
        result.index = answer.link.ifi_index;
        result.is_can = answer.link.ifi_type == ARPHRD_CAN;
        result.is_up = (answer.link.ifi_flags & IFF_UP) != 0U;
    }
    return result;
}

}  // namespace rsi::hal
