// rsi-ecu-r5f-lock-step: the image for the Cortex-R5F in simulated time, for simulation only. The firmware
// steps when a SimulationSync frame says so, at the time that the frame says; everything else is as in
// rsi-ecu-r5f.
#include <optional>

#include "hal/memory/virtual_clock.hpp"
#include "images/zynqmp_r5/ecu_image.hpp"
#include "images/zynqmp_r5/warning_recorder.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "sil/simulation/lock_step_receiver.hpp"
#include "sil/simulation/simulation.hpp"

namespace {

// A cycle has five frames at most; more wait only if a simulation does not wait for its answer.
using Receiver = sil::LockStepReceiver<32U>;

// Simulated time stands still for as long as the simulation likes.
class NoWatchdog final : public rsi::hal::Watchdog {
 public:
    void feed() noexcept override {}
};

class LockStepImage {
 public:
    [[noreturn]] void run() noexcept {
        static_cast<void>(rsi::hal::zynqmp_r5::begin_run(rsi::hal::zynqmp_r5::fault_record()));
        static_cast<void>(controller_.open(rsi::image::unfiltered_can_settings()));
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
            rsi::image::Policy::wait(rsi::hal::Time::from_milliseconds(1));
        }
    }

 private:
    void begin() noexcept {
        const rsi::image::ParameterMemory parameters = rsi::image::parameter_memory();
        static_cast<void>(
            ecu_.emplace(receiver_, clock_, watchdog_).init(parameters.bytes, parameters.length));
    }

    rsi::hal::VirtualClock clock_;
    rsi::image::Controller controller_{rsi::image::MemoryMappedRegisters{}, clock_};
    rsi::image::WarningRecorder recorder_{controller_, rsi::image::last_warning()};
    Receiver receiver_{recorder_, clock_};
    NoWatchdog watchdog_;
    std::optional<rsi::application::RolloverEcu> ecu_;
};

LockStepImage ecu;

}  // namespace

int main() {
    ecu.run();
}
