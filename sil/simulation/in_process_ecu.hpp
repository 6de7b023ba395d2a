// In-process ECU: the firmware in the same process on a memory bus, stepped in simulated time.
#pragma once

#include <optional>

#include "application/load_record.hpp"
#include "application/rollover_ecu.hpp"
#include "hal/memory/memory_bus.hpp"
#include "hal/memory/memory_storage.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "sil/files/require_accepted.hpp"

namespace sil {

// For tests, benchmarks and replays; the firmware is the same as on a CAN interface.
class InProcessEcu {
 public:
    // With `learnt`, it starts as after a reset while driving, with this load in its storage. Throws
    // std::invalid_argument with the field's name when the parameters are refused.
    explicit InProcessEcu(const rsi::Parameters& parameters,
                          const std::optional<rsi::LearntLoad>& learnt = std::nullopt)
        : ecu_{bus_.endpoint(0U), clock_, watchdog_} {
        if (learnt) {
            const application::LoadRecord record =
                application::write_load_record(*learnt, application::check_word_of(parameters));
            storage_.write(record.data(), record.size());
            ecu_.use_storage(storage_);
            ecu_.set_reset_reason(hal::ResetReason::outside);
        }
        require_accepted(ecu_.init(parameters));
    }

    hal::CanBus& world_bus() { return bus_.endpoint(1U); }
    hal::VirtualClock& clock() { return clock_; }
    void step() { ecu_.step(0U); }
    const application::RolloverEcu& ecu() const { return ecu_; }

 private:
    class NoWatchdog final : public hal::Watchdog {
     public:
        void feed() noexcept override {}
    };

    hal::VirtualClock clock_;
    hal::MemoryBus<2U> bus_{clock_};
    NoWatchdog watchdog_;
    hal::MemoryStorage<application::load_record_length> storage_;
    application::RolloverEcu ecu_;
};

}  // namespace sil
