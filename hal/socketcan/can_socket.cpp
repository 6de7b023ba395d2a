// CAN socket on socket, setsockopt, bind and recvmsg.
#include "hal/socketcan/can_socket.hpp"

#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "hal/linux/timespec.hpp"

namespace rsi::hal {
namespace {

template <typename Value>
bool set_option(int descriptor, int level, int option, const Value& value) noexcept {
    return setsockopt(descriptor, level, option, &value, sizeof(value)) == 0;
}

// Beyond the system-wide limit only a privileged process may go; the others get what the limit allows.
void enlarge_receive_buffer(int descriptor, int bytes) noexcept {
    if (!set_option(descriptor, SOL_SOCKET, SO_RCVBUFFORCE, bytes)) {
        set_option(descriptor, SOL_SOCKET, SO_RCVBUF, bytes);
    }
}

bool configure(int descriptor, const CanSocketSettings& settings) noexcept {
    const int on = 1;
    const int own = settings.receive_own_frames ? 1 : 0;
    const can_err_mask_t every_error = CAN_ERR_MASK;
    const auto filter_bytes = static_cast<socklen_t>(settings.filter_count * sizeof(can_filter));
    enlarge_receive_buffer(descriptor, settings.receive_buffer_bytes);
    return setsockopt(descriptor, SOL_CAN_RAW, CAN_RAW_FILTER, settings.filters.data(), filter_bytes) == 0 &&
           set_option(descriptor, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, every_error) &&
           set_option(descriptor, SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, own) &&
           set_option(descriptor, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, on) &&
           set_option(descriptor, SOL_SOCKET, SO_RXQ_OVFL, on) &&
           set_option(descriptor, SOL_SOCKET, SO_TIMESTAMPNS, on);
}

OpenFailure failure_of_socket(int system_error) noexcept {
    switch (system_error) {
        case EAFNOSUPPORT:
        case EPROTONOSUPPORT:
        case ESOCKTNOSUPPORT:
            return OpenFailure::kernel_without_can;
        case EPERM:
        case EACCES:
            return OpenFailure::not_permitted;
        default:
            return OpenFailure::system;
    }
}

CanSocketResult refused(OpenFailure failure, int system_error) noexcept {
    return {failure, system_error, -1};
}

CanSocketResult bind_to_interface(int descriptor, const InterfaceName& name) noexcept {
    const InterfaceLookup interface = look_up_interface(name);
    if (interface.system_error != 0) {
        return refused(
            interface.system_error == ENODEV ? OpenFailure::interface_missing : OpenFailure::system,
            interface.system_error);
    }
    if (!interface.is_can) {
        return refused(OpenFailure::interface_not_can, 0);
    }
    if (!interface.is_up) {
        return refused(OpenFailure::interface_down, 0);
    }
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = interface.index;
    if (bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
        return refused(OpenFailure::system, errno);
    }
    return {OpenFailure::none, 0, descriptor};
}

void read_ancillary(msghdr& message, ReadResult& result) noexcept {
    for (cmsghdr* item = CMSG_FIRSTHDR(&message); item != nullptr; item = CMSG_NXTHDR(&message, item)) {
        if (item->cmsg_level != SOL_SOCKET) {
            continue;
        }
        if (item->cmsg_type == SO_TIMESTAMPNS) {
            timespec stamp{};
            std::memcpy(&stamp, CMSG_DATA(item), sizeof(stamp));
            result.has_wall_stamp = true;
            result.wall_stamp = to_time(stamp);
        } else if (item->cmsg_type == SO_RXQ_OVFL) {
            std::memcpy(&result.drop_count, CMSG_DATA(item), sizeof(result.drop_count));
            result.has_drop_count = true;
        }
    }
}

}  // namespace

CanSocketResult open_can_socket(const CanSocketSettings& settings) noexcept {
    const int descriptor = socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW);
    if (descriptor < 0) {
        return refused(failure_of_socket(errno), errno);
    }
    CanSocketResult result;
    if (configure(descriptor, settings)) {
        result = bind_to_interface(descriptor, settings.interface_name);
    } else {
        result = refused(OpenFailure::system, errno);
    }
    if (result.failure != OpenFailure::none) {
        close(descriptor);
    }
    return result;
}

ReadResult read_frame(int descriptor, canfd_frame& kernel_frame) noexcept {
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(timespec)) + CMSG_SPACE(sizeof(std::uint32_t))>
        ancillary;
    iovec part{&kernel_frame, sizeof(kernel_frame)};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = ancillary.data();
    message.msg_controllen = ancillary.size();

    ReadResult result;
    const ssize_t bytes = recvmsg(descriptor, &message, MSG_DONTWAIT);
    if (bytes < 0) {
        result.system_error = errno;
        return result;
    }
    result.bytes = static_cast<std::size_t>(bytes);
    read_ancillary(message, result);
    return result;
}

}  // namespace rsi::hal
