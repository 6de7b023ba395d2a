// Substitutes of the emulator for the silicon's (QEMU 7.2, machine xlnx-zcu102).
#pragma once

#include <cstdint>

#include "hal/zynqmp_r5/can_frame_layout.hpp"
#include "hal/zynqmp_r5/emulator/supervisor.hpp"
#include "rsi/hal/clock.hpp"

namespace rsi::hal::zynqmp_r5 {

// QEMU 7.2 passes on the words of Linux' can_frame: identifier in the lowest bits, extension in bit 31,
// remote request in 30, error in 29; the first byte of data in the lowest bits.
struct EmulatorCanFrameLayout {
    static constexpr CanFrameWords pack(const CanFrame& frame) {
        return detail::pack(frame.identifier | (frame.extended ? extension : 0U), frame, false);
    }
    static constexpr bool unpack(const CanFrameWords& words, CanFrame& frame) {
        const std::uint32_t word = words[0];
        frame.extended = (word & extension) != 0U;
        frame.identifier = word & (frame.extended ? 0x1FFF'FFFFU : 0x7FFU);
        detail::unpack(words, frame, false);
        return (word & (remote_request | error)) == 0U;
    }
    static constexpr CanFilter filter(const CanAcceptance& accepted) {
        return CanFilter{accepted.mask | extension | remote_request | error, accepted.identifier};
    }

 private:
    static constexpr std::uint32_t extension{1U << 31U};
    static constexpr std::uint32_t remote_request{1U << 30U};
    static constexpr std::uint32_t error{1U << 29U};
};

struct EmulatorPolicy {
    static constexpr std::uint32_t timer_clock_hz{133'000'000U};
    static constexpr std::uint32_t can_clock_hz{100'000'000U};  // without effect
    using CanLayout = EmulatorCanFrameLayout;
    // A busy host stops the emulator for longer than five cycles, at times for seconds.
    template <typename Registers>
    using Watchdog = emulator::SupervisorWatchdog<Registers, 5000U>;
    template <typename Registers>
    using Reset = emulator::SupervisorReset<Registers>;
    // Each look at the timer wakes the emulator's main loop, which the CAN interface needs too. Therefore the
    // looks come rarely at first and then more often: the loop takes hundredths of the spare time, a third of
    // it where the emulator is itself emulated.
    static void wait(Time spare) noexcept {
        for (auto pause = static_cast<std::uint32_t>(spare.nanoseconds / 64); pause > 0U; --pause) {
            asm volatile("nop");
        }
    }
};

}  // namespace rsi::hal::zynqmp_r5
