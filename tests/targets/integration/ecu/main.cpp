// The least platform around the installed application: its first frame says whether the parameters were
// taken.
#include <cstdint>
#include <cstdio>

#include "application/rollover_ecu.hpp"
#include "can_dbc/codec/message.hpp"

extern "C" const unsigned char rsi_parameter_section[application::section::length];

namespace {

using can_dbc::RolloverWarning;

class Bus final : public hal::CanBus {
 public:
    hal::ReceiveResult receive(hal::CanFrame&) noexcept override { return hal::ReceiveResult::empty; }
    hal::SendResult send(const hal::CanFrame& frame) noexcept override {
        if (frame.identifier == RolloverWarning::identifier) {
            warning = can_dbc::decode<RolloverWarning>(frame.data).value;
        }
        ++frames;
        return hal::SendResult::sent;
    }
    hal::BusState state() const noexcept override { return hal::BusState::error_active; }
    hal::BusStatistics statistics() const noexcept override { return {}; }

    RolloverWarning warning{};
    int frames{0};
};

struct Clock final : hal::Clock {
    hal::Time now() const noexcept override { return {}; }
};

struct Watchdog final : hal::Watchdog {
    void feed() noexcept override {}
};

void start_with(std::size_t length) {
    Bus bus;
    const Clock clock;
    Watchdog watchdog;
    application::RolloverEcu ecu{bus, clock, watchdog};
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
