// System watchdog of the low-power domain, SWDT0 (UG1085, chapter "System Watchdog Timers"; UG1087, module
// SWDT).
#pragma once

#include <cstdint>

#include "hal/zynqmp_r5/registers.hpp"
#include "rsi/hal/watchdog.hpp"

namespace rsi::hal::zynqmp_r5 {

namespace watchdog {
inline constexpr RegisterAddress base{0xFF15'0000U};
inline constexpr RegisterAddress mode{base + 0x00U};
inline constexpr RegisterAddress counter_control{base + 0x04U};
inline constexpr RegisterAddress restart{base + 0x08U};

// Keys without which a write is ignored.
inline constexpr std::uint32_t mode_key{0xABCU << 12U};
inline constexpr std::uint32_t counter_key{0x248U << 14U};
inline constexpr std::uint32_t restart_key{0x1999U};

inline constexpr std::uint32_t enable{1U << 0U};
inline constexpr std::uint32_t reset_output{1U << 1U};
inline constexpr std::uint32_t reset_pulse_16{3U << 4U};  // 16 clock periods
inline constexpr std::uint32_t divide_by_8{0U};

// The counter has 24 bits; a restart sets the upper 12 from the control register and the lower 12 to one.
inline constexpr std::uint32_t prescaler{8U};
inline constexpr std::uint32_t lower_bits{12U};
inline constexpr std::uint32_t largest_upper{0xFFFU};
}  // namespace watchdog

// Expires `limit_ms` after the last feeding, up to one part in a hundred later. The platform management unit
// decides what expiry resets: docs/targets.md.
template <typename Registers, std::uint32_t clock_hz, std::uint32_t limit_ms>
class SystemWatchdog final : public Watchdog {
 public:
    explicit SystemWatchdog(Registers registers) noexcept : registers_{registers} {}

    void start() noexcept {
        registers_.write(watchdog::mode, watchdog::mode_key);  // off, while it is set
        registers_.write(watchdog::counter_control,
                         watchdog::counter_key | (upper << 2U) | watchdog::divide_by_8);
        registers_.write(watchdog::mode, watchdog::mode_key | watchdog::reset_pulse_16 |
                                             watchdog::reset_output | watchdog::enable);
        registers_.write(watchdog::restart, watchdog::restart_key);
    }

    void feed() noexcept override { registers_.write(watchdog::restart, watchdog::restart_key); }

 private:
    static constexpr std::uint64_t counts{(std::uint64_t{clock_hz} / watchdog::prescaler) * limit_ms / 1000U};
    static constexpr auto upper = static_cast<std::uint32_t>(counts >> watchdog::lower_bits);
    static_assert(upper >= 1U && upper <= watchdog::largest_upper,
                  "the watchdog's counter cannot hold this limit");

    Registers registers_;
};

}  // namespace rsi::hal::zynqmp_r5
