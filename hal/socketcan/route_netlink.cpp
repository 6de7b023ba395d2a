// Route netlink on a socket that lives for one question.
#include "hal/socketcan/route_netlink.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

namespace rsi::hal {
namespace {

struct Message {
    nlmsghdr header{};
    RouteAnswer answer{};
};

int exchange(int descriptor, const nlmsghdr& request, RouteAnswer& answer) noexcept {
    if (send(descriptor, &request, request.nlmsg_len, 0) < 0) {
        return errno;
    }
    Message message;
    const ssize_t bytes = recv(descriptor, &message, sizeof(message), MSG_DONTWAIT);
    if (bytes < 0) {
        return errno;
    }
    if (static_cast<std::size_t>(bytes) < sizeof(nlmsghdr) + sizeof(ifinfomsg)) {
        return EPROTO;
    }
    answer = message.answer;
    return message.header.nlmsg_type == NLMSG_ERROR ? -message.answer.error.error : 0;
}

}  // namespace

int ask_route(const nlmsghdr& request, RouteAnswer& answer) noexcept {
    const int descriptor = socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE);
    if (descriptor < 0) {
        return errno;
    }
    const int system_error = exchange(descriptor, request, answer);
    close(descriptor);
    return system_error;
}

}  // namespace rsi::hal
