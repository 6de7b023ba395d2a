// rsi-ecu-r5f: the firmware on the Cortex-R5F of the Zynq UltraScale+ MPSoC.
#include <cstdint>

#include "application/rollover_ecu.hpp"
#include "hal/zynqmp_r5/can_controller.hpp"
#include "hal/zynqmp_r5/policy.hpp"
#include "hal/zynqmp_r5/registers.hpp"
#include "hal/zynqmp_r5/timer.hpp"
#include "images/zynqmp_r5/parameters.hpp"

namespace {

using hal::zynqmp_r5::MemoryMappedRegisters;
using hal::zynqmp_r5::Policy;

class NoWatchdog final : public hal::Watchdog {
 public:
    void feed() noexcept override {}
};

}  // namespace

int main() {
    hal::zynqmp_r5::TimerClock<MemoryMappedRegisters, Policy> clock{MemoryMappedRegisters{}};
    hal::zynqmp_r5::CanController<MemoryMappedRegisters, Policy> bus{MemoryMappedRegisters{}, clock};
    NoWatchdog watchdog;
    application::RolloverEcu ecu{bus, clock, watchdog};
    clock.start();
    bus.open();
    ecu.init(image::parameters);
    hal::Time due = clock.now() + hal::Time::from_milliseconds(10);
    for (;;) {
        clock.update();
        std::uint32_t missed = 0U;
        if (!(clock.now() < due)) {
            due = due + hal::Time::from_milliseconds(10);
            while (!(clock.now() < due)) {
                due = due + hal::Time::from_milliseconds(10);
                ++missed;
            }
            ecu.step(missed);
        }
    }
}
