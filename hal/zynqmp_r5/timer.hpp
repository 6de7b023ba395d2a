// Time and the 10 ms tick from one free-running counter of TTC0.
#pragma once

#include <cstdint>

#include "hal/interface/clock.hpp"
#include "hal/zynqmp_r5/registers.hpp"

namespace hal::zynqmp_r5 {

namespace ttc {
inline constexpr RegisterAddress base{0xFF11'0000U};
inline constexpr RegisterAddress clock_control{base + 0x00U};
inline constexpr RegisterAddress counter_control{base + 0x0CU};
inline constexpr RegisterAddress counter_value{base + 0x18U};
}  // namespace ttc

template <typename Registers, typename Policy>
class TimerClock final : public Clock {
 public:
    explicit TimerClock(Registers registers) noexcept : registers_{registers} {}

    void start() noexcept {
        registers_.write(ttc::counter_control, 1U);
        registers_.write(ttc::clock_control, (9U << 1U) | 1U);
        registers_.write(ttc::counter_control, 1U << 4U);
        last_ = registers_.read(ttc::counter_value) & 0xFFFFU;
    }

    // To be called at least every 0.5 s, which is when the counter's lower half comes round.
    void update() noexcept {
        const std::uint32_t count = registers_.read(ttc::counter_value) & 0xFFFFU;
        counts_ += (count - last_) & 0xFFFFU;
        last_ = count;
    }

    Time now() const noexcept override {
        // counts * 1024 / f, in nanoseconds
        const std::uint64_t periods = counts_ * 1024U;
        const std::uint64_t seconds = periods / Policy::timer_clock_hz;
        const std::uint64_t rest = periods % Policy::timer_clock_hz;
        return Time{static_cast<std::int64_t>(seconds * 1'000'000'000U +
                                              rest * 1'000'000'000U / Policy::timer_clock_hz)};
    }

 private:
    Registers registers_;
    std::uint64_t counts_{0U};
    std::uint32_t last_{0U};
};

}  // namespace hal::zynqmp_r5
