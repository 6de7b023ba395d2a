// What differs between the silicon and its emulator (QEMU 7.2, machine xlnx-zcu102), in one type each. An
// image chooses one when it is built (RSI_ZYNQMP_POLICY_SILICON or RSI_ZYNQMP_POLICY_EMULATOR); everything
// else is the same.
#pragma once

#include <cstdint>

#include "hal/interface/clock.hpp"
#include "hal/zynqmp_r5/can_frame_layout.hpp"
#include "hal/zynqmp_r5/emulator/supervisor.hpp"
#include "hal/zynqmp_r5/system_reset.hpp"
#include "hal/zynqmp_r5/system_watchdog.hpp"

namespace hal::zynqmp_r5 {

// As UG1085 and UG1087 have it, with the clocks that Xilinx' board files set.
struct SiliconPolicy {
    static constexpr std::uint32_t timer_clock_hz{100'000'000U};  // LPD_LSBUS_CLK
    static constexpr std::uint32_t can_clock_hz{100'000'000U};    // CAN0_REF_CLK
    using CanLayout = SiliconCanFrameLayout;
    template <typename Registers>
    using Watchdog = SystemWatchdog<Registers, 100'000'000U, 50U>;  // LPD_LSBUS_CLK; five cycles
    template <typename Registers>
    using Reset = SystemReset<Registers>;
    // Called between two looks for something to do; `spare` is the time in which nothing is due.
    static void wait(Time spare) noexcept { static_cast<void>(spare); }
};

struct EmulatorPolicy {
    static constexpr std::uint32_t timer_clock_hz{133'000'000U};
    static constexpr std::uint32_t can_clock_hz{100'000'000U};  // without effect
    using CanLayout = EmulatorCanFrameLayout;
    // A busy host stops the emulator for longer than five cycles.
    template <typename Registers>
    using Watchdog = emulator::SupervisorWatchdog<Registers, 2000U>;
    template <typename Registers>
    using Reset = emulator::SupervisorReset<Registers>;
    // Each look at the timer wakes the emulator's main loop, which the CAN interface needs too. So the looks
    // come rarely at first and then more often: the loop takes microseconds of each spare millisecond, half
    // of it where the emulator is itself emulated.
    static void wait(Time spare) noexcept {
        for (auto pause = static_cast<std::uint32_t>(spare.nanoseconds / 1024); pause > 0U; --pause) {
            asm volatile("nop");
        }
    }
};

#if defined(RSI_ZYNQMP_POLICY_EMULATOR)
using Policy = EmulatorPolicy;
#elif defined(RSI_ZYNQMP_POLICY_SILICON)
using Policy = SiliconPolicy;
#endif

}  // namespace hal::zynqmp_r5
