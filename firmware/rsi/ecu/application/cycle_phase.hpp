// Cycle phase: lets the platform's cycle follow the frames of the IMU, so that what they say waits no longer
// than it must.
#pragma once

#include <cstdint>

#include "rsi/hal/clock.hpp"

namespace rsi::application {

// A cycle with a period of its own takes up a frame 0 to 10 ms after it came, by the chance of when the two
// control units were switched on. Here each cycle moves the next one a little towards the phase in which the
// frame of the IMU has just come. The models' step stays 10 ms: the IMU's period is the same.
class CyclePhase {
 public:
    static constexpr hal::Time period = hal::Time::from_milliseconds(10);
    static constexpr hal::Time oldest = hal::Time::from_milliseconds(15);

    // Time from the IMU's frame to the cycle. The frames that other sensors send at the same time come in it:
    // four of eight bytes take 1 ms at 500 kbit/s.
    static constexpr hal::Time aim{1'000'000};

    // 1 % of the period, less than the models notice. The phase is found within half a second, and kept while
    // the clocks of both control units differ by less than that.
    static constexpr hal::Time largest_shift{100'000};

    // A jitter of the frames becomes an eighth of it in the cycle.
    static constexpr std::int32_t gain_divisor{8};

    // How much later than one period from now the next cycle should begin; earlier if negative. Magnitude up
    // to largest_shift. `waited`: time since the newest usable frame of the IMU was received; zero is
    // returned where that is negative or more than one and a half periods (the next frame may be a little
    // late), so that without frames the cycle keeps its own period.
    static constexpr hal::Time shift(hal::Time waited) {
        if (waited < hal::Time{} || oldest < waited) {
            return hal::Time{};
        }
        const std::int32_t late = narrow(waited) - narrow(aim);
        const std::int32_t to_nearer = (late > narrow(period) / 2) ? late - narrow(period) : late;
        const std::int32_t wanted = -to_nearer / gain_divisor;
        const std::int32_t most = narrow(largest_shift);
        return hal::Time{(wanted > most) ? most : ((wanted < -most) ? -most : wanted)};
    }

 private:
    // Up to 2 s, as all times here are: half as many instructions on a controller.
    static constexpr std::int32_t narrow(hal::Time time) {
        return static_cast<std::int32_t>(time.nanoseconds);
    }
};

}  // namespace rsi::application
