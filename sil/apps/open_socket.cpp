#include "sil/apps/open_socket.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "can_dbc/generated/rollover_warning.hpp"
#include "hal/linux/steady_clock.hpp"

namespace sil {

void open_or_throw(hal::SocketCanBus& socket, const std::string& interface) {
    hal::SocketCanSettings settings;
    settings.interface_name = interface.c_str();
    const hal::OpenResult opened = socket.open(settings);
    if (!opened) {
        throw std::runtime_error(opened.message());
    }
}

void check_interface(const std::string& interface) {
    hal::SocketCanBus socket;
    open_or_throw(socket, interface);
}

bool hears_ecu(hal::SocketCanBus& socket, hal::Time longest) {
    hal::SteadyClock clock;
    const hal::Time deadline = clock.now() + longest;
    hal::CanFrame frame;
    while (clock.now() < deadline && socket.wait_for_frame(deadline - clock.now())) {
        while (socket.receive(frame) == hal::ReceiveResult::frame) {
            if (frame.identifier == can_dbc::RolloverStatus::identifier) {
                return true;
            }
        }
    }
    return false;
}

void expect_ecu(hal::SocketCanBus& socket, const std::string& interface) {
    if (!hears_ecu(socket, hal::Time::from_milliseconds(5000))) {
        throw std::runtime_error(
            fmt::format("no ECU responds on {0}. Start one first: rsi-ecu --interface {0} --parameters "
                        "FILE (without --lock-step)",
                        interface));
    }
}

}  // namespace sil
