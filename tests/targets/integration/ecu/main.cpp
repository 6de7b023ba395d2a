// The least platform around the installed application: its first frame says whether the parameters were
// taken.
#include <cstdint>
#include <cstdio>

#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"

extern "C" const unsigned char rsi_parameter_section[rsi::application::section::length];

namespace {

using rsi::can_dbc::RolloverWarning;

class Bus final : public rsi::hal::CanBus {
 public:
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame&) noexcept override {
        return rsi::hal::ReceiveResult::empty;
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override {
        if (frame.identifier == RolloverWarning::identifier) {
            warning = rsi::can_dbc::decode<RolloverWarning>(frame.data).value;
        }
        ++frames;
        return rsi::hal::SendResult::sent;
    }
    rsi::hal::BusState state() const noexcept override { return rsi::hal::BusState::error_active; }
    rsi::hal::BusStatistics statistics() const noexcept override { return {}; }

    RolloverWarning warning{};
    int frames{0};
};

struct Clock final : rsi::hal::Clock {
    rsi::hal::Time now() const noexcept override { return {}; }
};

struct Watchdog final : rsi::hal::Watchdog {
    void feed() noexcept override {}
};

void start_with(std::size_t length) {
    Bus bus;
    const Clock clock;
    Watchdog watchdog;
    rsi::application::RolloverEcu ecu{bus, clock, watchdog};
    ecu.init(rsi_parameter_section, length);
    ecu.step(0U);
    std::printf("%d frames, state %s, parameters refused: %s\n", bus.frames,
                RolloverWarning::name_of(bus.warning.state),
                RolloverWarning::name_of(bus.warning.parameters_refusal));
}

}  // namespace

int main() {
    start_with(sizeof rsi_parameter_section);
    start_with(sizeof rsi_parameter_section - 1U);
}
