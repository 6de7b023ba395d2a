// The firmware's main loop on this controller, for the image that is flashed and for those made to test it.
#pragma once

#include <cstdint>

#include "hal/zynqmp_r5/can_controller.hpp"
#include "hal/zynqmp_r5/cycle_tick.hpp"
#include "hal/zynqmp_r5/policy.hpp"
#include "hal/zynqmp_r5/registers.hpp"
#include "hal/zynqmp_r5/startup/exceptions.hpp"
#include "hal/zynqmp_r5/timer_clock.hpp"
#include "images/zynqmp_r5/warning_recorder.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"

namespace rsi::image {

using hal::zynqmp_r5::MemoryMappedRegisters;
using hal::zynqmp_r5::Policy;
using Clock = hal::zynqmp_r5::TimerClock<MemoryMappedRegisters, Policy::timer_clock_hz>;
using Controller = hal::zynqmp_r5::CanController<MemoryMappedRegisters, Policy::CanLayout>;
using Watchdog = Policy::Watchdog<MemoryMappedRegisters>;

inline constexpr std::uint32_t can_bit_rate{500'000U};
inline constexpr hal::Time cycle_time = hal::Time::from_milliseconds(10);

// The section at its fixed address; the linker script supplies its bounds.
struct ParameterMemory {
    const std::uint8_t* bytes;
    std::size_t length;
};
ParameterMemory parameter_memory() noexcept;

// The controller lets the identifiers of the application through, and few others with them.
constexpr hal::zynqmp_r5::CanSettings can_settings() {
    using can_dbc::RolloverWarning;
    constexpr auto sent = application::sent_identifiers;
    static_assert(sent[0] == RolloverWarning::identifier, "it has a filter of its own, far from the others");
    std::array<std::uint32_t, sent.size() - 1U> others{};
    for (std::size_t i = 0U; i < others.size(); ++i) {
        others[i] = sent[i + 1U];
    }
    hal::zynqmp_r5::CanSettings settings{};
    settings.timing = hal::zynqmp_r5::can_bit_timing<Policy::can_clock_hz, can_bit_rate>();
    settings.accepted[0] = hal::zynqmp_r5::accepting(application::received_identifiers);
    settings.accepted[1].identifier = RolloverWarning::identifier;
    settings.accepted[2] = hal::zynqmp_r5::accepting(others);
    settings.accepted_count = 3U;
    return settings;
}

// For images that take one frame more.
constexpr hal::zynqmp_r5::CanSettings unfiltered_can_settings() {
    hal::zynqmp_r5::CanSettings settings = can_settings();
    settings.accepted_count = 0U;
    return settings;
}

// `Bus` is what the application sees of the controller: a WarningRecorder, or a hal::CanBus that is made like
// one. `Ecu` is started and stepped as a RolloverEcu is, and shifts the cycle as one.
template <typename Bus, typename Ecu = application::RolloverEcu>
class EcuImage {
 public:
    [[noreturn]] void run(const hal::zynqmp_r5::CanSettings& settings) noexcept {
        ecu_.set_reset_reason(hal::zynqmp_r5::begin_run(hal::zynqmp_r5::fault_record()));
        clock_.start();
        watchdog_.start();
        // A controller that does not respond is tried again by receive(); the watchdog would not help it.
        static_cast<void>(controller_.open(settings));
        const ParameterMemory parameters = parameter_memory();
        static_cast<void>(ecu_.init(parameters.bytes, parameters.length));
        hal::zynqmp_r5::CycleTick<Clock> tick{clock_, cycle_time};
        for (;;) {
            std::uint32_t missed = 0U;
            if (tick.is_due(missed)) {
                ecu_.step(missed);
                tick.shift(ecu_.cycle_shift());
            }
            controller_.take_waiting();
            Policy::wait(tick.spare());
        }
    }

 private:
    Clock clock_{MemoryMappedRegisters{}};
    Controller controller_{MemoryMappedRegisters{}, clock_};
    Bus bus_{controller_, last_warning()};
    Watchdog watchdog_{MemoryMappedRegisters{}};
    Ecu ecu_{bus_, clock_, watchdog_};
};

}  // namespace rsi::image
