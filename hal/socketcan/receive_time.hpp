// Receive time: the kernel's wall-clock stamp of a frame, moved to the monotonic clock.
#pragma once

#include "rsi/hal/clock.hpp"

namespace rsi::hal {

// The kernel stamps a frame on CLOCK_REALTIME when the driver hands it over. Its age is the wall clock's time
// now minus the stamp; the monotonic receive time is now minus that age. `wall_now` and `monotonic_now` are
// read together. Someone may set the wall clock between stamp and reading; the result therefore stays between
// `earliest` (when the queue was last seen empty) and `monotonic_now`.
constexpr Time monotonic_receive_time(Time wall_stamp, Time wall_now, Time monotonic_now,
                                      Time earliest) noexcept {
    const Time estimate = monotonic_now - (wall_now - wall_stamp);
    if (monotonic_now < estimate) {
        return monotonic_now;
    }
    return estimate < earliest ? earliest : estimate;
}

}  // namespace rsi::hal
