// rsi-ecu-r5f-lock-step: the image for the Cortex-R5F in simulated time, for simulation only. The firmware
// steps when a SimulationSync frame says so, at the time that the frame says; everything else is as in
// rsi-ecu-r5f.
#include <optional>

#include "application/rollover_ecu.hpp"
#include "can_dbc/generated/rollover_warning.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "images/zynqmp_r5/ecu_image.hpp"
#include "images/zynqmp_r5/warning_recorder.hpp"
#include "sil/simulation/lock_step_receiver.hpp"
#include "sil/simulation/simulation.hpp"

namespace {

// A cycle has five frames at most; more wait only if a simulation does not wait for its answer.
using Receiver = sil::LockStepReceiver<32U>;

// Simulated time stands still for as long as the simulation likes.
class NoWatchdog final : public hal::Watchdog {
 public:
    void feed() noexcept override {}
};

class LockStepImage {
 public:
    [[noreturn]] void run() noexcept {
        static_cast<void>(hal::zynqmp_r5::begin_run(hal::zynqmp_r5::fault_record()));
        static_cast<void>(controller_.open(image::unfiltered_can_settings()));
        // One cycle unasked, so that the starter of the emulator knows that the firmware runs.
        begin();
        ecu_->step(0U);
        for (;;) {
            while (receiver_.cycle_is_complete()) {
                // A new run must not see what the ECU has learnt and counted in the one before.
                if (receiver_.run_begins()) {
                    begin();
                }
                ecu_->step(0U);
            }
            image::Policy::wait(hal::Time::from_milliseconds(1));
        }
    }

 private:
    void begin() noexcept {
        const image::ParameterMemory parameters = image::parameter_memory();
        static_cast<void>(
            ecu_.emplace(receiver_, clock_, watchdog_).init(parameters.bytes, parameters.length));
    }

    hal::VirtualClock clock_;
    image::Controller controller_{image::MemoryMappedRegisters{}, clock_};
    image::WarningRecorder recorder_{controller_, image::last_warning()};
    Receiver receiver_{recorder_, clock_};
    NoWatchdog watchdog_;
    std::optional<application::RolloverEcu> ecu_;
};

LockStepImage ecu;

}  // namespace

int main() {
    ecu.run();
}
