// Conversion between hal::Time and the kernel's timespec.
#pragma once

#include <time.h>

#include "rsi/hal/clock.hpp"

namespace rsi::hal {

inline constexpr std::int64_t nanoseconds_per_second{1'000'000'000};

constexpr Time to_time(const timespec& value) noexcept {
    return Time{static_cast<std::int64_t>(value.tv_sec) * nanoseconds_per_second + value.tv_nsec};
}

// For times from zero on, as CLOCK_MONOTONIC gives them.
inline timespec to_timespec(Time time) noexcept {
    timespec value{};
    value.tv_sec = static_cast<time_t>(time.nanoseconds / nanoseconds_per_second);
    value.tv_nsec = static_cast<long>(time.nanoseconds % nanoseconds_per_second);
    return value;
}

}  // namespace rsi::hal
