// Clock and cycle tick on a fake of the timer's counter.
#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "hal/zynqmp_r5/cycle_tick.hpp"
#include "hal/zynqmp_r5/timer_clock.hpp"
#include "tests/hal/zynqmp_r5/register_fake.hpp"

namespace rsi::hal::zynqmp_r5::testing {
namespace {

// Counts 1024 periods of its clock as one, from the last restart on.
class TimerDevice final : public Device {
 public:
    explicit TimerDevice(std::uint32_t counter_mask) : counter_mask_{counter_mask} {}

    void advance(std::uint64_t counts) { counts_ += counts; }

    std::uint32_t on_read(RegisterAddress address) override {
        return address == timer::counter_value ? static_cast<std::uint32_t>(counts_) & counter_mask_ : 0U;
    }
    void on_write(RegisterAddress address, std::uint32_t value) override {
        if (address == timer::counter_control && (value & timer::restart) != 0U) {
            counts_ = 0U;
        }
    }

 private:
    std::uint64_t counts_{0xFFF0U};
    std::uint32_t counter_mask_;
};

// Silicon: 32 bits at 100 MHz. Emulator: 16 bits at 133 MHz.
constexpr std::uint32_t whole_word = std::numeric_limits<std::uint32_t>::max();
using SiliconClock = TimerClock<FakeRegisters, 100'000'000U>;
using EmulatorClock = TimerClock<FakeRegisters, 133'000'000U>;

TEST(TimerClock, StartsByTheseWritesInThisOrder) {
    TimerDevice device{whole_word};
    SiliconClock clock{FakeRegisters{&device}};
    clock.start();
    const std::vector<Write> expected{
        {0xFF11'000CU, 0x01U},  // stop
        {0xFF11'0000U, 0x13U},  // 1024 periods a count
        {0xFF11'000CU, 0x10U},  // from zero, without interval and match
    };
    EXPECT_EQ(device.writes, expected);
    EXPECT_EQ(clock.now(), Time{});
}

TEST(TimerClock, OneCountIsTenMicrosecondsAndAQuarter) {
    TimerDevice device{whole_word};
    SiliconClock clock{FakeRegisters{&device}};
    clock.start();
    device.advance(1U);
    EXPECT_EQ(clock.now().nanoseconds, 10'240);
    device.advance(976U);
    EXPECT_EQ(clock.now().nanoseconds, 977 * 10'240);
}

TEST(TimerClock, NeverGoesBackAndLosesNothingWhenTheCounterComesRound) {
    TimerDevice device{0xFFFFU};
    EmulatorClock clock{FakeRegisters{&device}};
    clock.start();
    Time last = clock.now();
    for (int step = 0; step < 100'000; ++step) {
        device.advance(61U);
        if (step % 7 == 0) {
            clock.update();
        }
        ASSERT_FALSE(clock.now() < last);
        last = clock.now();
    }
    // 6,100,000 counts of 1024 periods at 133 MHz, rounded down.
    EXPECT_EQ(last.nanoseconds, 6'100'000LL * 1'024'000 / 133);
}

TEST(TimerClock, IsExactAfterADay) {
    TimerDevice device{0xFFFFU};
    EmulatorClock clock{FakeRegisters{&device}};
    clock.start();
    const std::uint64_t steps = 200'000U;
    for (std::uint64_t step = 0U; step < steps; ++step) {
        device.advance(56'117U);
        clock.update();
    }
    EXPECT_EQ(clock.now().nanoseconds, static_cast<std::int64_t>(steps) * 56'117LL * 1'024'000 / 133);
    EXPECT_GT(clock.now().nanoseconds, 86'400'000'000'000);
}

class CycleTickTest : public ::testing::Test {
 protected:
    // The tick's first period begins when it is made, so the clock runs before.
    void SetUp() override {
        clock.start();
        tick.emplace(clock, Time::from_milliseconds(10));
    }
    bool is_due() { return tick->is_due(missed); }
    // Counts until the tick is due; the counter advances by one between two looks.
    std::uint32_t wait() {
        std::uint32_t counts = 0U;
        while (!is_due() && counts < 100'000U) {
            device.advance(1U);
            ++counts;
        }
        return counts;
    }

    TimerDevice device{whole_word};
    SiliconClock clock{FakeRegisters{&device}};
    std::optional<CycleTick<SiliconClock>> tick;
    std::uint32_t missed{99U};
};

TEST_F(CycleTickTest, ComesEveryTenMillisecondsOnAFixedGrid) {
    for (std::int64_t cycle = 1; cycle <= 1000; ++cycle) {
        wait();
        ASSERT_EQ(missed, 0U);
        const std::int64_t lateness = clock.now().nanoseconds - cycle * 10'000'000;
        ASSERT_GE(lateness, 0);
        ASSERT_LE(lateness, 10'240);  // one count
    }
}

TEST_F(CycleTickTest, IsShiftedForGood) {
    wait();
    tick->shift(Time{-300'000});
    wait();
    EXPECT_NEAR(static_cast<double>(clock.now().nanoseconds), 19'700'000.0, 10'240.0);
    wait();
    EXPECT_EQ(missed, 0U);
    EXPECT_NEAR(static_cast<double>(clock.now().nanoseconds), 29'700'000.0, 10'240.0);
}

TEST_F(CycleTickTest, CountsWhatWasMissedAndGoesOnOnTheGrid) {
    wait();
    device.advance(3'500U);  // 35.84 ms: the next three are over
    ASSERT_TRUE(is_due());
    EXPECT_EQ(missed, 2U);
    EXPECT_FALSE(is_due());
    wait();
    EXPECT_EQ(missed, 0U);
    EXPECT_LE(clock.now().nanoseconds - 50'000'000, 10'240);
}

TEST_F(CycleTickTest, TellsTheTimeInWhichNothingIsDue) {
    is_due();
    EXPECT_EQ(tick->spare(), Time::from_milliseconds(10));
    device.advance(500U);  // 5.12 ms
    is_due();
    EXPECT_EQ(tick->spare().nanoseconds, 4'880'000);
    device.advance(500U);
    ASSERT_TRUE(is_due());
    EXPECT_EQ(tick->spare(), Time{});
}

TEST_F(CycleTickTest, ALateCycleWithinItsPeriodIsNoneMissed) {
    wait();
    device.advance(1'900U);  // 19.46 ms
    ASSERT_TRUE(is_due());
    EXPECT_EQ(missed, 0U);
}

class JumpingClock {
 public:
    Time now() const { return time; }
    Time update() { return now(); }
    Time time{};
};

TEST(CycleTick, ALeapOfTheClockIsCountedUpToABound) {
    JumpingClock clock;
    CycleTick<JumpingClock> tick{clock, Time::from_milliseconds(10)};
    std::uint32_t missed = 0U;
    clock.time = Time::from_milliseconds(1'000'000'000);
    ASSERT_TRUE(tick.is_due(missed));
    EXPECT_EQ(missed, most_missed_periods);
    EXPECT_FALSE(tick.is_due(missed));
    clock.time = clock.time + Time::from_milliseconds(10);
    ASSERT_TRUE(tick.is_due(missed));
    EXPECT_EQ(missed, 0U);
}

}  // namespace
}  // namespace rsi::hal::zynqmp_r5::testing
