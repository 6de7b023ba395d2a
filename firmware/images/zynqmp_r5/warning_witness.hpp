// Warning witness: a bus that notes what the last warning frame carried, for the one that a fault sends after
// it.
#pragma once

#include <cstdint>

#include "can_dbc/generated/rollover_warning.hpp"
#include "hal/interface/can_bus.hpp"

namespace image {

// End-to-end counter of the last warning frame that the controller took. Outside of any object, so that the
// reaction to a fault finds it.
inline std::uint8_t last_warning_counter{14U};

class WarningWitness final : public hal::CanBus {
 public:
    // `bus` must outlive this one.
    explicit WarningWitness(hal::CanBus& bus) noexcept : bus_{bus} {}

    hal::ReceiveResult receive(hal::CanFrame& frame) noexcept override { return bus_.receive(frame); }

    hal::SendResult send(const hal::CanFrame& frame) noexcept override {
        const hal::SendResult result = bus_.send(frame);
        if (result == hal::SendResult::sent && frame.identifier == can_dbc::RolloverWarning::identifier) {
            last_warning_counter = static_cast<std::uint8_t>(frame.data[1] & 0x0FU);
        }
        return result;
    }

    hal::BusState state() const noexcept override { return bus_.state(); }
    hal::BusStatistics statistics() const noexcept override { return bus_.statistics(); }

 private:
    hal::CanBus& bus_;
};

}  // namespace image
