// Behaviour of the host's watchdog on a virtual clock.
#include "hal/linux/software_watchdog.hpp"

#include <gtest/gtest.h>

#include "hal/memory/virtual_clock.hpp"

namespace rsi::hal {
namespace software_watchdog_test {
namespace {

constexpr Time milliseconds(std::int64_t count) {
    return Time::from_milliseconds(count);
}

class SoftwareWatchdogTest : public ::testing::Test {
 protected:
    VirtualClock clock{milliseconds(100)};
    SoftwareWatchdog watchdog{clock, milliseconds(30)};
};

TEST_F(SoftwareWatchdogTest, DoesNotExpireWhileFedInTime) {
    for (int i = 0; i < 100; ++i) {
        clock.advance(milliseconds(30));
        EXPECT_FALSE(watchdog.expired());
        watchdog.feed();
    }
    EXPECT_EQ(watchdog.last_feeding(), milliseconds(100 + 100 * 30));
}

TEST_F(SoftwareWatchdogTest, ExpiresWhenItIsNeverFed) {
    clock.advance(milliseconds(30));
    EXPECT_FALSE(watchdog.expired());
    clock.advance(Time{1});
    EXPECT_TRUE(watchdog.expired());
}

TEST_F(SoftwareWatchdogTest, ExpiresWhenFeedingStops) {
    clock.advance(milliseconds(10));
    watchdog.feed();
    clock.advance(milliseconds(31));
    EXPECT_TRUE(watchdog.expired());
}

TEST_F(SoftwareWatchdogTest, FeedingTooLateDoesNotReviveIt) {
    clock.advance(milliseconds(31));
    watchdog.feed();
    EXPECT_TRUE(watchdog.expired());
    EXPECT_EQ(watchdog.last_feeding(), milliseconds(100));
}

TEST_F(SoftwareWatchdogTest, StaysExpired) {
    clock.advance(milliseconds(31));
    ASSERT_TRUE(watchdog.expired());
    watchdog.feed();
    EXPECT_TRUE(watchdog.expired());
}

}  // namespace
}  // namespace software_watchdog_test
}  // namespace rsi::hal
