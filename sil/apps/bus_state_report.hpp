// Bus state report: tells the user when the bus fails, when it is back, and what keeps it away.
#pragma once

#include <string>

#include "hal/socketcan/socket_can_bus.hpp"

namespace sil {

class BusStateReport {
 public:
    explicit BusStateReport(const std::string& interface) : interface_{interface} {}

    // Once a cycle. Prints a line when the state is not what it was, and when a restart is refused for
    // another reason than the last one.
    void follow(const rsi::hal::SocketCanBus& bus);

 private:
    const std::string& interface_;
    rsi::hal::BusState state_{rsi::hal::BusState::error_active};
    int refusal_{0};
};

}  // namespace sil
