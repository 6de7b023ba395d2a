// BusOffSchedule: later each time, never later than the longest, and soon again once a frame was received.
#include "rsi/hal/bus_off_schedule.hpp"

#include <gtest/gtest.h>

namespace rsi::hal {
namespace {

TEST(BusOffSchedule, WaitsTwiceAsLongEachTimeUpToTheLongest) {
    BusOffSchedule schedule;
    for (const int milliseconds : {100, 200, 400, 800, 1600, 1600, 1600}) {
        EXPECT_EQ(schedule.next(), Time::from_milliseconds(milliseconds));
    }
}

TEST(BusOffSchedule, StartsAnewWhenAFrameWasHeard) {
    BusOffSchedule schedule;
    schedule.next();
    schedule.next();
    schedule.reset();
    EXPECT_EQ(schedule.next(), BusOffSchedule::shortest);
    EXPECT_EQ(schedule.next(), Time::from_milliseconds(200));
}

}  // namespace
}  // namespace rsi::hal
