// Emulator only: reset and watchdog by the emulator's supervisor, a program on the first A53 core
// (firmware/images/zynqmp_r5/emulator/release.S). QEMU 7.2 has neither the watchdog nor the reset register of
// the silicon.
//
// The supervisor counts a word down every RSI_SUPERVISOR_PERIOD_MS, and resets the machine when it comes to
// zero. Zero from the start: nothing happens.
#pragma once

#include <cstdint>

#include "hal/zynqmp_r5/emulator/supervisor_words.h"
#include "hal/zynqmp_r5/registers.hpp"
#include "rsi/hal/watchdog.hpp"

namespace rsi::hal::zynqmp_r5::emulator {

inline constexpr RegisterAddress countdown{RSI_SUPERVISOR_COUNTDOWN};

template <typename Registers, std::uint32_t limit_ms>
class SupervisorWatchdog final : public Watchdog {
 public:
    explicit SupervisorWatchdog(Registers registers) noexcept : registers_{registers} {}

    void start() noexcept { feed(); }
    void feed() noexcept override { registers_.write(countdown, limit_ms / RSI_SUPERVISOR_PERIOD_MS); }

 private:
    Registers registers_;
};

template <typename Registers>
struct SupervisorReset {
    static void request(Registers registers) noexcept { registers.write(countdown, 1U); }
};

}  // namespace rsi::hal::zynqmp_r5::emulator
