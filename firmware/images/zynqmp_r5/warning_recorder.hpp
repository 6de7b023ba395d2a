// Warning recorder: a bus that notes the end-to-end counter of the warning frames, for the one that a fault
// sends after them.
#pragma once

#include <cstdint>

#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/hal/can_bus.hpp"

namespace rsi::image {

// State that a fault may find half done: it can come between any two instructions. Hence one volatile byte,
// which the compiler writes in program order, and not after the registers of the controller.
class LastWarning {
 public:
    // Counter of the warning frame that receivers may have seen last.
    std::uint8_t counter() const noexcept { return counter_; }
    void set_counter(std::uint8_t counter) noexcept { counter_ = counter; }

    // Counter of a warning frame that goes out instead of the next one.
    std::uint8_t next_counter() const noexcept {
        return static_cast<std::uint8_t>((counter_ + 1U) % (can_dbc::e2e::profile_11_largest_counter + 1U));
    }

 private:
    volatile std::uint8_t counter_{can_dbc::e2e::profile_11_largest_counter};  // the first one is zero
};

// The image's one; the reaction to a fault has no other way to the objects of the main loop.
LastWarning& last_warning() noexcept;

class WarningRecorder final : public hal::CanBus {
 public:
    // Both must outlive this one.
    WarningRecorder(hal::CanBus& bus, LastWarning& last) noexcept : bus_{bus}, last_{last} {}

    hal::ReceiveResult receive(hal::CanFrame& frame) noexcept override { return bus_.receive(frame); }

    // The counter is noted before the frame is handed over. A fault in between then skips one value, which
    // receivers accept; noted afterwards, it would repeat one, which they take for no new frame and drop.
    hal::SendResult send(const hal::CanFrame& frame) noexcept override {
        if (frame.identifier != can_dbc::RolloverWarning::identifier) {
            return bus_.send(frame);
        }
        const std::uint8_t before = last_.counter();
        last_.set_counter(can_dbc::e2e::profile_11_counter(frame.data.data()));
        const hal::SendResult result = bus_.send(frame);
        if (result != hal::SendResult::sent) {
            last_.set_counter(before);
        }
        return result;
    }

    hal::BusState state() const noexcept override { return bus_.state(); }
    hal::BusStatistics statistics() const noexcept override { return bus_.statistics(); }

 private:
    hal::CanBus& bus_;
    LastWarning& last_;
};

}  // namespace rsi::image
