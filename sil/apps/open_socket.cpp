#include "sil/apps/open_socket.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "hal/linux/steady_clock.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"

namespace sil {

void open_or_throw(rsi::hal::SocketCanBus& socket, const std::string& interface) {
    rsi::hal::SocketCanSettings settings;
    settings.interface_name = interface.c_str();
    const rsi::hal::OpenResult opened = socket.open(settings);
    if (!opened) {
        throw std::runtime_error(opened.message());
    }
}

void check_interface(const std::string& interface) {
    rsi::hal::SocketCanBus socket;
    open_or_throw(socket, interface);
}

bool hears_ecu(rsi::hal::SocketCanBus& socket, rsi::hal::Time longest) {
    rsi::hal::SteadyClock clock;
    const rsi::hal::Time deadline = clock.now() + longest;
    rsi::hal::CanFrame frame;
    while (clock.now() < deadline && socket.wait_for_frame(deadline - clock.now())) {
        while (socket.receive(frame) == rsi::hal::ReceiveResult::frame) {
            if (frame.identifier == rsi::can_dbc::RolloverStatus::identifier) {
                return true;
            }
        }
    }
    return false;
}

void expect_ecu(rsi::hal::SocketCanBus& socket, const std::string& interface) {
    if (!hears_ecu(socket, rsi::hal::Time::from_milliseconds(5000))) {
        throw std::runtime_error(
            fmt::format("no ECU responds on {0}. Start one first: rsi-ecu --interface {0} --parameters "
                        "FILE (without --lock-step)",
                        interface));
    }
}

}  // namespace sil
