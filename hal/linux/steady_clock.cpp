// Steady clock on clock_gettime and clock_nanosleep.
#include "hal/linux/steady_clock.hpp"

#include <cerrno>

#include "hal/linux/timespec.hpp"

namespace rsi::hal {

Time SteadyClock::now() const noexcept {
    timespec value{};
    clock_gettime(CLOCK_MONOTONIC, &value);
    return to_time(value);
}

void SteadyClock::wait_until(Time deadline) const noexcept {
    const timespec value = to_timespec(deadline);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &value, nullptr) == EINTR) {
    }
}

}  // namespace rsi::hal
