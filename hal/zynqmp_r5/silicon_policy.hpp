// The silicon: clocks, layout of frames, watchdog and reset.
#pragma once

#include <cstdint>

#include "hal/zynqmp_r5/can_frame_layout.hpp"
#include "hal/zynqmp_r5/system_reset.hpp"
#include "hal/zynqmp_r5/system_watchdog.hpp"
#include "rsi/hal/clock.hpp"

namespace rsi::hal::zynqmp_r5 {

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

}  // namespace rsi::hal::zynqmp_r5
