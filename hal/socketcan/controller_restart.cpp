// Controller restart by RTM_NEWLINK requests.
#include "hal/socketcan/controller_restart.hpp"

#include <linux/can/netlink.h>

#include <array>
#include <cerrno>

#include "hal/socketcan/route_netlink.hpp"

namespace rsi::hal {
namespace {

struct LinkRequest {
    nlmsghdr header{};
    ifinfomsg link{};
};

// The attribute IFLA_CAN_RESTART in that of the interface's kind, as the kernel nests them.
struct RestartRequest {
    LinkRequest head{};
    rtattr information{};
    rtattr kind{};
    std::array<char, 4> kind_name{'c', 'a', 'n', '\0'};
    rtattr data{};
    rtattr restart{};
    std::uint32_t restart_now{1U};
};
static_assert(sizeof(RestartRequest) == sizeof(LinkRequest) + 4U * sizeof(rtattr) + 8U,
              "no padding in between");

rtattr attribute(int type, std::size_t content_bytes) noexcept {
    return {static_cast<unsigned short>(RTA_LENGTH(content_bytes)), static_cast<unsigned short>(type)};
}

LinkRequest link_request(int index, std::size_t bytes) noexcept {
    LinkRequest request;
    request.header.nlmsg_len = static_cast<__u32>(bytes);
    request.header.nlmsg_type = RTM_NEWLINK;
    request.header.nlmsg_flags = NLM_F_REQUEST | NLM_F_ACK;
    request.link.ifi_index = index;
    return request;
}

int ask_for_restart(int index) noexcept {
    RestartRequest request;
    request.head = link_request(index, sizeof(request));
    request.restart = attribute(IFLA_CAN_RESTART, sizeof(request.restart_now));
    request.data = attribute(IFLA_INFO_DATA, sizeof(rtattr) + sizeof(request.restart_now));
    request.kind = attribute(IFLA_INFO_KIND, request.kind_name.size());
    request.information = attribute(IFLA_LINKINFO, sizeof(request) - sizeof(request.head) - sizeof(rtattr));
    RouteAnswer answer{};
    return ask_route(request.head.header, answer);
}

int set_up(int index, bool up) noexcept {
    LinkRequest request = link_request(index, sizeof(request));
    request.link.ifi_change = IFF_UP;
    if (up) {
        request.link.ifi_flags = IFF_UP;
    }
    RouteAnswer answer{};
    return ask_route(request.header, answer);
}

ControllerRestartResult refused(int system_error) noexcept {
    return {ControllerRestart::refused, system_error};
}

ControllerRestartResult take_down_and_up(int index) noexcept {
    const int down = set_up(index, false);
    const int up = set_up(index, true);
    const int system_error = down != 0 ? down : up;
    return system_error == 0 ? ControllerRestartResult{ControllerRestart::done, 0} : refused(system_error);
}

}  // namespace

ControllerRestartResult restart_controller(const InterfaceName& name) noexcept {
    const InterfaceLookup interface = look_up_interface(name);
    if (interface.system_error != 0) {
        return refused(interface.system_error);
    }
    const int system_error = ask_for_restart(interface.index);
    switch (system_error) {
        case 0:
            return {ControllerRestart::done, 0};
        case EBUSY:
            return {ControllerRestart::not_bus_off, 0};
        case EINVAL:
            return {ControllerRestart::left_to_kernel, 0};
        case EOPNOTSUPP:
            return take_down_and_up(interface.index);
        default:
            return refused(system_error);
    }
}

}  // namespace rsi::hal
