// The virtual CAN interface of these tests, by way of ioctl, so that no other program is needed.
#include "tests/system/vcan/interface_fixture.hpp"

#include <linux/can.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace rsi::hal::testing {
namespace {

[[noreturn]] void give_up(const char* action) {
    std::fprintf(stderr,
                 "Interface %s: %s: %s. Next: run these tests with `tests/run vcan`, or under "
                 "`cmake/environment/with_vcan`, which make a place where it exists and may be configured.\n",
                 interface_name().c_str(), action, std::strerror(errno));
    std::exit(1);
}

class ControlSocket {
 public:
    ControlSocket() : descriptor_(socket(AF_INET, SOCK_DGRAM, 0)) {
        std::strncpy(request_.ifr_name, interface_name().c_str(), IFNAMSIZ - 1);
    }
    ~ControlSocket() { close(descriptor_); }
    ControlSocket(const ControlSocket&) = delete;
    ControlSocket& operator=(const ControlSocket&) = delete;

    ifreq& request() { return request_; }
    void call(unsigned long code, const char* action) {
        if (ioctl(descriptor_, code, &request_) != 0) {
            give_up(action);
        }
    }

 private:
    int descriptor_;
    ifreq request_{};
};

}  // namespace

std::string interface_name() {
    const char* name = std::getenv("RSI_CAN_INTERFACE");
    return name == nullptr ? "vcan0" : name;
}

void set_interface_up(bool up) {
    ControlSocket control;
    control.call(SIOCGIFFLAGS, "reading its flags");
    const int flags = control.request().ifr_flags;
    control.request().ifr_flags = static_cast<short>(up ? (flags | IFF_UP) : (flags & ~IFF_UP));
    control.call(SIOCSIFFLAGS, up ? "switching it on" : "switching it off");
}

void set_interface_mtu(int bytes) {
    set_interface_up(false);
    ControlSocket control;
    control.request().ifr_mtu = bytes;
    control.call(SIOCSIFMTU, "setting its largest frame size (mtu)");
    set_interface_up(true);
}

void send_raw(std::uint32_t can_id, std::uint8_t second_byte) {
    const int descriptor = socket(PF_CAN, SOCK_RAW, CAN_RAW);
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(if_nametoindex(interface_name().c_str()));
    can_frame frame{};
    frame.can_id = can_id;
    frame.can_dlc = 8U;
    frame.data[1] = second_byte;
    if (bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0 ||
        write(descriptor, &frame, sizeof(frame)) != static_cast<ssize_t>(sizeof(frame))) {
        give_up("sending a raw frame");
    }
    close(descriptor);
}

void InterfaceTest::SetUp() {
    set_interface_mtu(CANFD_MTU);
    open_or_fail(first);
    open_or_fail(second);
}

void InterfaceTest::TearDown() {
    set_interface_up(true);
}

void InterfaceTest::open_or_fail(SocketCanBus& bus, SocketCanSettings settings) {
    const std::string name = interface_name();
    settings.interface_name = name.c_str();
    const OpenResult result = bus.open(settings);
    ASSERT_TRUE(static_cast<bool>(result)) << result.message();
}

ReceiveResult InterfaceTest::receive_soon(SocketCanBus& bus, CanFrame& frame) {
    bus.wait_for_frame(longest_wait);
    return bus.receive(frame);
}

}  // namespace rsi::hal::testing
