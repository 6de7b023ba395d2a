#include "sil/apps/bus_state_report.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <system_error>

namespace sil {
namespace {

const char* describe(rsi::hal::BusState state) {
    constexpr std::array words{"error-active again", "error-passive", "bus-off", "down or gone"};
    return words[static_cast<std::size_t>(state)];
}

}  // namespace

void BusStateReport::follow(const rsi::hal::SocketCanBus& bus) {
    const rsi::hal::BusState state = bus.state();
    const int refusal = bus.bus_off_report().refusal;
    if (state == state_ && refusal == refusal_) {
        return;
    }
    if (state != state_) {
        fmt::print("rsi-ecu: {} is {}\n", interface_, describe(state));
    }
    if (refusal != 0 && refusal != refusal_) {
        fmt::print(
            "rsi-ecu: {} cannot be restarted: {}. Next: run rsi-ecu as root or with CAP_NET_ADMIN, or let "
            "the "
            "kernel do it: ip link set {} type can restart-ms 100\n",
            interface_, std::generic_category().message(refusal), interface_);
    }
    std::fflush(stdout);
    state_ = state;
    refusal_ = refusal;
}

}  // namespace sil
