// Time from one free-running counter of the triple timer counter TTC0 (UG1085, chapter "Timers and
// Counters").
#pragma once

#include <cstdint>
#include <limits>
#include <numeric>

#include "hal/zynqmp_r5/registers.hpp"
#include "rsi/hal/clock.hpp"

namespace rsi::hal::zynqmp_r5 {

namespace timer {
inline constexpr RegisterAddress base{0xFF11'0000U};  // TTC0, first counter
inline constexpr RegisterAddress clock_control{base + 0x00U};
inline constexpr RegisterAddress counter_control{base + 0x0CU};
inline constexpr RegisterAddress counter_value{base + 0x18U};

// Clock control: bit 0 enables the prescaler, bits 4 to 1 are its exponent less one: divides by 2^10.
inline constexpr std::uint32_t prescale_by_1024{(9U << 1U) | 1U};
inline constexpr std::uint32_t prescaler{1024U};

// Counter control: bit 0 stops the counter, bit 4 sets it to zero. Neither interval nor match, counting up:
// it comes round after 2^32 counts on silicon and after 2^16 in QEMU, so the lower half is used.
inline constexpr std::uint32_t stop{1U << 0U};
inline constexpr std::uint32_t restart{1U << 4U};
inline constexpr std::uint32_t counter_mask{0xFFFFU};
}  // namespace timer

// `clock_hz` is the timer's input. One count is 1024 of its periods: 10.24 us at 100 MHz. Exact in the long
// run: no fraction of a count is ever dropped.
template <typename Registers, std::uint32_t clock_hz>
class TimerClock final : public Clock {
 public:
    explicit TimerClock(Registers registers) noexcept : registers_{registers} {}

    // Starts the counter; the time is zero.
    void start() noexcept {
        registers_.write(timer::counter_control, timer::stop);
        registers_.write(timer::clock_control, timer::prescale_by_1024);
        registers_.write(timer::counter_control, timer::restart);
        whole_ = Time{};
        rest_ = 0U;
        last_count_ = count();
    }

    // Call it before the counter comes round, which takes 0.67 s at 100 MHz; later, that much time is lost.
    // The time now.
    Time update() noexcept {
        const std::uint32_t now = count();
        const std::uint32_t counts = rest_ + ((now - last_count_) & timer::counter_mask);
        last_count_ = now;
        whole_ = whole_ + Time{static_cast<std::int64_t>((counts / divisor) * nanoseconds)};
        rest_ = counts % divisor;
        return whole_ + rest_time(rest_);
    }

    Time now() const noexcept override {
        const std::uint32_t counts = rest_ + ((count() - last_count_) & timer::counter_mask);
        const std::uint32_t whole = (counts / divisor) * nanoseconds;
        return whole_ + Time{static_cast<std::int64_t>(whole)} + rest_time(counts % divisor);
    }

 private:
    // `divisor` counts take `nanoseconds` ns, in lowest terms.
    static constexpr std::uint64_t counts_per_1024_seconds{clock_hz};
    static constexpr std::uint64_t scale{timer::prescaler * 1'000'000'000ULL};
    static constexpr std::uint64_t common{std::gcd(scale, counts_per_1024_seconds)};
    static constexpr auto divisor = static_cast<std::uint32_t>(counts_per_1024_seconds / common);
    static constexpr auto nanoseconds = static_cast<std::uint32_t>(scale / common);
    static_assert(scale / common <= std::numeric_limits<std::uint32_t>::max());
    static constexpr std::uint64_t most_counts{std::uint64_t{timer::counter_mask} + divisor};
    static_assert((most_counts / divisor + 1U) * nanoseconds <= std::numeric_limits<std::uint32_t>::max() &&
                      std::uint64_t{divisor} * nanoseconds <= std::numeric_limits<std::uint32_t>::max(),
                  "this timer clock needs wider arithmetic");

    static constexpr Time rest_time(std::uint32_t rest) {
        return Time{static_cast<std::int64_t>((rest * nanoseconds) / divisor)};
    }

    std::uint32_t count() const noexcept {
        return registers_.read(timer::counter_value) & timer::counter_mask;
    }

    Registers registers_;
    Time whole_{};
    std::uint32_t rest_{0U};  // counts that `whole_` does not hold, fewer than `divisor`
    std::uint32_t last_count_{0U};
};

}  // namespace rsi::hal::zynqmp_r5
