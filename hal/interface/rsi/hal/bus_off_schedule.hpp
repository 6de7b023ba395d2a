// Bus-off schedule: how long a node stays off the bus before it is restarted.
#pragma once

#include "rsi/hal/clock.hpp"

namespace rsi::hal {

// A node that is bus-off stays off for the shortest time, and for twice as long after each further bus-off
// with no frame received in between, up to the longest. ISO 11898-1 demands 128 times 11 recessive bits,
// which is 11 ms at 125 kbit/s.
class BusOffSchedule {
 public:
    static constexpr Time shortest = Time::from_milliseconds(100);
    static constexpr Time longest = Time::from_milliseconds(1600);

    // The wait from now on; the next one is longer.
    Time next() noexcept {
        const Time wait = wait_;
        const Time twice = wait + wait;
        wait_ = twice < longest ? twice : longest;
        return wait;
    }

    // A frame was received: the bus works.
    void reset() noexcept { wait_ = shortest; }

 private:
    Time wait_{shortest};
};

}  // namespace rsi::hal
