// In-process ECU: the firmware in the same process on a memory bus, stepped in simulated time.
#pragma once

#include <optional>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/memory_storage.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "rsi/ecu/application/load_record.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
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
            const rsi::application::LoadRecord record = rsi::application::write_load_record(
                {*learnt, 0.0F}, rsi::application::check_word_of(parameters));
            storage_.write(record.data(), record.size());
            ecu_.use_storage(storage_);
            ecu_.set_reset_reason(rsi::hal::ResetReason::outside);
        }
        require_accepted(ecu_.init(parameters));
    }

    rsi::hal::CanBus& world_bus() { return bus_.endpoint(1U); }
    rsi::hal::VirtualClock& clock() { return clock_; }
    void step() { ecu_.step(0U); }
    const rsi::application::RolloverEcu& ecu() const { return ecu_; }

 private:
    class NoWatchdog final : public rsi::hal::Watchdog {
     public:
        void feed() noexcept override {}
    };

    rsi::hal::VirtualClock clock_;
    rsi::hal::MemoryBus<2U> bus_{clock_};
    NoWatchdog watchdog_;
    rsi::hal::MemoryStorage<rsi::application::load_record_length> storage_;
    rsi::application::RolloverEcu ecu_;
};

}  // namespace sil
