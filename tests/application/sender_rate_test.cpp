// The surplus of frames over those that one sender sends, at its limits.
#include "application/sender_rate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace testing_application {
namespace {

constexpr std::int64_t ns_per_ms = 1'000'000;
constexpr std::int64_t round_ns = std::int64_t{1} << 48U;  // after it the ticks come round

class ASenderRate : public ::testing::Test {
 protected:
    // A cycle that reads so many frames, the newest of which came so long after that of the cycle before.
    void read(int frames, std::int64_t elapsed_ms) {
        now_ns += elapsed_ms * ns_per_ms;
        for (int frame = 0; frame < frames; ++frame) {
            rate.count(hal::Time{now_ns});
        }
        rate.end_cycle();
    }

    // How many cycles of 10 ms with so many frames each are read until it is doubled; `most` if it is not.
    int cycles_until_doubled(int frames, int most = 100) {
        int cycles = 0;
        while (!rate.is_doubled() && (cycles < most)) {
            read(frames, 10);
            ++cycles;
        }
        return cycles;
    }

    void run_alone(int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            read(1, 10);
            ASSERT_FALSE(rate.is_doubled()) << "cycle " << cycle;
        }
    }

    std::int64_t now_ns{12'345 * ns_per_ms};
    application::SenderRate rate;
};

TEST_F(ASenderRate, IsNotDoubledByOneSender) {
    run_alone(100'000);
}

TEST_F(ASenderRate, OfTwoSendersIsDoubledWithin110Milliseconds) {
    run_alone(200);
    EXPECT_EQ(cycles_until_doubled(2), 11);
}

// A few frames of a cycle are enough; that there are more proves no more.
TEST_F(ASenderRate, OfManyFramesIsDoubledWithin40MillisecondsHoweverManyTheyAre) {
    for (const int frames : {4, 11, 64, 300}) {
        rate = {};
        run_alone(200);
        EXPECT_EQ(cycles_until_doubled(frames), 4) << frames;
    }
    rate = {};
    run_alone(200);
    EXPECT_EQ(cycles_until_doubled(3), 5);
}

TEST_F(ASenderRate, OfASecondSenderEvery80MillisecondsIsDoubledInTheEndAndOfOneEvery90Not) {
    for (const int every : {8, 9}) {
        rate = {};
        run_alone(200);
        for (int cycle = 0; cycle < 10'000; ++cycle) {
            read((cycle % every == 0) ? 2 : 1, 10);
        }
        EXPECT_EQ(rate.is_doubled(), every == 8);
    }
}

TEST_F(ASenderRate, IsSingleAgainWhenTheSurplusIsUsedUp) {
    run_alone(200);
    cycles_until_doubled(2);
    for (int cycle = 0; cycle < 58; ++cycle) {
        read(1, 10);
        ASSERT_TRUE(rate.is_doubled()) << "cycle " << cycle;
    }
    read(1, 10);
    EXPECT_FALSE(rate.is_doubled());
    EXPECT_EQ(cycles_until_doubled(2), 8);  // from there, and not from the lower end
}

TEST_F(ASenderRate, SaturatesHoweverLongThereAreTwo) {
    for (int cycle = 0; cycle < 10'000; ++cycle) {
        read(64, 10);
    }
    for (int cycle = 0; cycle < 59; ++cycle) {
        read(1, 10);
    }
    EXPECT_FALSE(rate.is_doubled());
}

TEST_F(ASenderRate, IsSingleAfterALongSilence) {
    cycles_until_doubled(2);
    ASSERT_TRUE(rate.is_doubled());
    read(0, 10);
    EXPECT_TRUE(rate.is_doubled());  // nothing has been read that says otherwise
    read(1, 100);
    EXPECT_FALSE(rate.is_doubled());
}

// A cycle finds none, two, or one and the rest of the other's; the newest is up to a frame late.
TEST_F(ASenderRate, IsNotDoubledByFramesThatCycleAndBusShift) {
    constexpr std::array frames{0, 2, 1, 0, 0, 3, 1, 2, 0, 1};
    constexpr std::array late_ms{0, 4, 9, 0, 0, 7, 2, 9, 0, 0};
    static_assert(frames.size() == late_ms.size());
    std::int64_t before_ms = 0;
    for (int cycle = 0; cycle < 10'000; ++cycle) {
        const auto index = static_cast<std::size_t>(cycle) % frames.size();
        if (frames[index] > 0) {
            const std::int64_t newest_ms = 10 * std::int64_t{cycle} + late_ms[index];
            read(frames[index], newest_ms - before_ms);
            before_ms = newest_ms;
        }
        ASSERT_FALSE(rate.is_doubled()) << "cycle " << cycle;
    }
}

TEST_F(ASenderRate, IsNotDoubledByABurst) {
    run_alone(200);
    read(64, 10);
    EXPECT_FALSE(rate.is_doubled());
    read(64, 10);
    EXPECT_FALSE(rate.is_doubled());
    run_alone(100);
}

TEST_F(ASenderRate, IsNotDoubledByWhatIsReadAfterACycleThatCameLate) {
    for (const int late_ms : {30, 200, 640, 2000}) {
        run_alone(200);
        read(late_ms / 10, late_ms);
        EXPECT_FALSE(rate.is_doubled()) << late_ms;
    }
}

// What the bus has held up for 320 ms comes afterwards, faster than it was sent.
TEST_F(ASenderRate, IsNotDoubledByFramesThatComeLaterAtAnySpeed) {
    for (const int frames : {3, 4, 8, 32}) {
        run_alone(200);
        read(1, 320);
        for (int waiting = 31; waiting > 0; waiting -= frames - 1) {
            read(std::min(frames, waiting + 1), 10);
            ASSERT_FALSE(rate.is_doubled()) << frames;
        }
        run_alone(1);
    }
}

TEST_F(ASenderRate, RemembersAGapOfMoreThan35Milliseconds) {
    run_alone(200);
    read(1, 34);
    EXPECT_EQ(cycles_until_doubled(4), 4);
    rate = {};
    run_alone(200);
    read(1, 36);
    EXPECT_EQ(cycles_until_doubled(4), 5);
}

TEST_F(ASenderRate, RemembersNoMoreThan320MillisecondsOfAllGaps) {
    for (const int gap_ms : {280, 320, 321, 3'600'000}) {
        rate = {};
        run_alone(200);
        read(1, gap_ms);
        EXPECT_EQ(cycles_until_doubled(4), (gap_ms < 320) ? 14 : 15) << gap_ms;
    }
    rate = {};
    run_alone(200);
    for (int gap = 0; gap < 10'000; ++gap) {
        read(1, 310);
    }
    EXPECT_EQ(cycles_until_doubled(4), 15);
}

TEST_F(ASenderRate, ForgetsAGapInACycleOfUpToTwoFrames) {
    for (const int frames : {1, 2, 3}) {
        rate = {};
        run_alone(200);
        read(1, 320);
        read(frames, 10);
        EXPECT_EQ(cycles_until_doubled(4), (frames <= 2) ? 4 : 15) << frames;
    }
}

TEST_F(ASenderRate, IsNotJudgedByAClockThatStandsOrGoesBack) {
    run_alone(200);
    for (int cycle = 0; cycle < 1000; ++cycle) {
        read(4, 0);
        ASSERT_FALSE(rate.is_doubled()) << "cycle " << cycle;
    }
    run_alone(1);
    read(2, -1000);
    EXPECT_FALSE(rate.is_doubled());
    read(1, std::numeric_limits<std::int32_t>::max());  // milliseconds: 25 days
    EXPECT_FALSE(rate.is_doubled());
    run_alone(200);
    EXPECT_EQ(cycles_until_doubled(2), 11);
}

TEST_F(ASenderRate, IsJudgedAsEverWhenTheTicksComeRound) {
    now_ns = round_ns - 2050 * ns_per_ms;
    run_alone(200);
    EXPECT_EQ(cycles_until_doubled(2), 11);
    EXPECT_GT(now_ns, round_ns);
    now_ns = -2050 * ns_per_ms;  // the clock has an arbitrary start
    rate = {};
    run_alone(200);
    EXPECT_EQ(cycles_until_doubled(2), 11);
}

// Nobody knows since when they have waited.
TEST_F(ASenderRate, IsNotDoubledByFramesThatWaitAtTheStart) {
    for (const std::int64_t start_ms : {0, 1, 5, 1000, 400'000'000}) {
        rate = {};
        now_ns = start_ms * ns_per_ms;
        read(64, 0);
        EXPECT_FALSE(rate.is_doubled()) << start_ms;
        run_alone(100);
    }
}

}  // namespace
}  // namespace testing_application
