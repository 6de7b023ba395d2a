// The cycle follows the frames of the IMU, or keeps its own period.
#include "rsi/ecu/application/cycle_phase.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>
#include <random>

#include "tests/application/bench.hpp"

namespace testing_application {
namespace {

using rsi::application::CyclePhase;
using rsi::hal::Time;

constexpr std::int64_t period_ns = 10'000'000;
constexpr std::int64_t aim_ns = CyclePhase::aim.nanoseconds;
constexpr std::int64_t largest_shift_ns = CyclePhase::largest_shift.nanoseconds;

double in_ms(std::int64_t time_ns) {
    return static_cast<double>(time_ns) * 1.0e-6;
}

// Control unit and IMU, each with a clock of its own, on one axis of time.
struct TwoClocks {
    std::int64_t imu_period_ns{period_ns};
    std::int64_t offset_ns{0};  // of the first frame
    std::function<std::int64_t()> delay_ns{[] { return std::int64_t{0}; }};

    // When the newest frame came, at `now_ns`; none before the first.
    std::optional<std::int64_t> newest(std::int64_t now_ns) {
        while (next_ns_ <= now_ns) {
            newest_ns_ = next_ns_;
            ++frames_;
            next_ns_ = offset_ns + frames_ * imu_period_ns + delay_ns();
        }
        return newest_ns_;
    }

    // Runs cycles, and gives how long the last one's newest frame had waited, in ms. Each period is within
    // its bound.
    double wait_ms_after(int cycles) {
        next_ns_ = offset_ns + delay_ns();
        std::int64_t waited_ns = 0;
        for (int cycle = 0; cycle < cycles; ++cycle) {
            const std::optional<std::int64_t> frame_ns = newest(now_ns_);
            waited_ns = frame_ns ? now_ns_ - *frame_ns : 2 * period_ns;
            const std::int64_t shift_ns = CyclePhase::shift(Time{waited_ns}).nanoseconds;
            EXPECT_LE(std::abs(shift_ns), largest_shift_ns);
            now_ns_ += period_ns + shift_ns;
        }
        return in_ms(waited_ns);
    }

    double now_ms() const { return in_ms(now_ns_); }

 private:
    std::int64_t now_ns_{period_ns};
    std::int64_t next_ns_{0};
    std::int64_t frames_{0};
    std::optional<std::int64_t> newest_ns_{};
};

TEST(CyclePhase, IsFoundInHalfASecondFromAnywhere) {
    for (std::int64_t offset_ns = 0; offset_ns < period_ns; offset_ns += 100'000) {
        TwoClocks clocks;
        clocks.offset_ns = offset_ns;
        EXPECT_NEAR(clocks.wait_ms_after(75), in_ms(aim_ns), 0.05) << offset_ns;
        clocks = TwoClocks{};
        clocks.offset_ns = offset_ns;
        EXPECT_NEAR(clocks.wait_ms_after(50), in_ms(aim_ns), 0.8) << offset_ns;
    }
}

TEST(CyclePhase, IsKeptWhileTheClocksDrift) {
    for (const std::int64_t drift_ppm : {-5000, -100, 100, 5000}) {
        for (std::int64_t offset_ns = 0; offset_ns < period_ns; offset_ns += 100'000) {
            TwoClocks clocks;
            clocks.imu_period_ns = period_ns + period_ns * drift_ppm / 1'000'000;
            clocks.offset_ns = offset_ns;
            EXPECT_NEAR(clocks.wait_ms_after(1'000), in_ms(aim_ns), 0.5) << drift_ppm << ' ' << offset_ns;
        }
    }
}

TEST(CyclePhase, TakesAnEighthOfTheFramesJitter) {
    std::mt19937 random{1U};
    TwoClocks clocks;
    clocks.delay_ns = [&random] { return static_cast<std::int64_t>(random() % 400'000U); };
    EXPECT_NEAR(clocks.wait_ms_after(1000), in_ms(aim_ns), 0.45);
    EXPECT_EQ(CyclePhase::shift(Time{aim_ns + 400'000}).nanoseconds, -50'000);
    EXPECT_EQ(CyclePhase::shift(Time{aim_ns - 400'000}).nanoseconds, 50'000);
}

TEST(CyclePhase, GoesToTheNearerFrame) {
    EXPECT_EQ(CyclePhase::shift(Time{aim_ns + 5'000'000}).nanoseconds, -largest_shift_ns);
    EXPECT_EQ(CyclePhase::shift(Time{aim_ns + 5'000'001}).nanoseconds, largest_shift_ns);
    EXPECT_EQ(CyclePhase::shift(Time{period_ns}).nanoseconds, largest_shift_ns);
    EXPECT_EQ(CyclePhase::shift(Time{period_ns + aim_ns}), Time{}) << "a frame was lost";
    EXPECT_EQ(CyclePhase::shift(Time{0}).nanoseconds, largest_shift_ns);
    EXPECT_EQ(CyclePhase::shift(Time{aim_ns}), Time{});
}

TEST(CyclePhase, StaysWhereThereIsNoFrameOrItsTimeIsWrong) {
    for (const std::int64_t waited_ns : {std::int64_t{-1}, std::int64_t{15'000'001}, INT64_MAX, INT64_MIN}) {
        EXPECT_EQ(CyclePhase::shift(Time{waited_ns}), Time{}) << waited_ns;
    }
}

// 1 % of 10 ms is the most that any sequence of frames can do.
TEST(CyclePhase, OtherRatesDoNoHarm) {
    for (const std::int64_t imu_period_ns : {1'000'000, 5'000'000, 7'300'000, 20'000'000, 100'000'000}) {
        TwoClocks clocks;
        clocks.imu_period_ns = imu_period_ns;
        clocks.wait_ms_after(1000);
        EXPECT_NEAR(clocks.now_ms(), in_ms(1001 * period_ns), in_ms(1000 * largest_shift_ns))
            << imu_period_ns;
    }
}

// The ECU's own, with cycles that come `delay_us` after the frames.
std::int64_t shift_of_the_ecu_ns(std::int64_t delay_us, const std::function<void(Bench&)>& change = {}) {
    Bench bench{large_suv(), Time{delay_us * 1000}};
    bench.run_until_ready();
    if (change) {
        change(bench);
    }
    bench.run_cycles(10);
    return bench.cycle_shift().nanoseconds;
}

TEST(CycleOfTheEcu, ComesOneMillisecondBehindTheImu) {
    EXPECT_EQ(shift_of_the_ecu_ns(1000), 0);
    EXPECT_EQ(shift_of_the_ecu_ns(1080), -10'000);
    EXPECT_EQ(shift_of_the_ecu_ns(4000), -largest_shift_ns);
    EXPECT_EQ(shift_of_the_ecu_ns(8000), largest_shift_ns);
}

TEST(CycleOfTheEcu, KeepsItsPeriodWithoutTheImu) {
    EXPECT_EQ(shift_of_the_ecu_ns(4000, [](Bench& bench) { bench.stop(Sensor::imu); }), 0);
}

TEST(CycleOfTheEcu, DoesNotFollowAnotherSensor) {
    EXPECT_EQ(shift_of_the_ecu_ns(4000,
                                  [](Bench& bench) {
                                      bench.stop(Sensor::roll_angle);
                                      bench.stop(Sensor::vehicle_motion);
                                  }),
              -largest_shift_ns);
}

TEST(CycleOfTheEcu, DoesNotFollowDamagedFrames) {
    EXPECT_EQ(shift_of_the_ecu_ns(4000,
                                  [](Bench& bench) {
                                      bench.tamper(Sensor::imu, [](rsi::hal::CanFrame& frame) {
                                          frame.data[3] = static_cast<std::uint8_t>(frame.data[3] ^ 1U);
                                      });
                                  }),
              0);
}

}  // namespace
}  // namespace testing_application
