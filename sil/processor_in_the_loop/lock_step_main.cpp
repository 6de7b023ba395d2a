// rsi-ecu-r5f-lock-step: the image for the Cortex-R5F in simulated time, for simulation only. The firmware steps when a
// SimulationSync frame says so, at the time that the frame says; everything else is as in rsi-ecu-r5f.
#include <optional>

#include "application/rollover_ecu.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "hal/zynqmp_r5/can_controller.hpp"
#include "hal/zynqmp_r5/policy.hpp"
#include "hal/zynqmp_r5/registers.hpp"
#include "images/zynqmp_r5/parameters.hpp"
#include "sil/simulation/lock_step_receiver.hpp"

namespace {

using hal::zynqmp_r5::MemoryMappedRegisters;
using hal::zynqmp_r5::Policy;

// A cycle has four frames; more only if several are sent at once.
using Receiver = sil::LockStepReceiver<32U>;

// Simulated time stands still for as long as the simulation likes.
class NoWatchdog final : public hal::Watchdog {
 public:
    void feed() noexcept override {}
};

}  // namespace

int main() {
    static hal::VirtualClock clock;
    static hal::zynqmp_r5::CanController<MemoryMappedRegisters, Policy> controller{MemoryMappedRegisters{},
                                                                                   clock};
    static Receiver bus{controller, clock};
    static NoWatchdog watchdog;
    static std::optional<application::RolloverEcu> ecu;
    controller.open();
    ecu.emplace(bus, clock, watchdog).init(image::parameters);
    // One cycle unasked, so that whoever starts the emulator knows that the firmware runs.
    ecu->step(0U);
    for (;;) {
        while (bus.cycle_is_complete()) {
            // A new run must not see what the ECU has learnt and counted in the one before.
            if (bus.run_begins()) {
                ecu.emplace(bus, clock, watchdog).init(image::parameters);
            }
            ecu->step(0U);
        }
    }
}
