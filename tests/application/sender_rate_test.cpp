// The surplus of frames over those that one sender sends, at its limits.
#include "rsi/ecu/application/sender_rate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace testing_application {
namespace {

class ASenderRate : public ::testing::Test {
 protected:
    // A cycle that reads so many frames, `missed` cycles after the one before.
    void read(int frames, std::uint32_t missed = 0U) {
        if (missed > 0U) {
            rate.miss(missed);
        }
        for (int frame = 0; frame < frames; ++frame) {
            rate.count();
        }
        rate.end_cycle();
    }

    void pause(int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            read(0);
        }
    }

    // How many cycles with so many frames each are read until it is doubled; `most` if it is not.
    int cycles_until_doubled(int frames, int most = 100) {
        int cycles = 0;
        while (!rate.is_doubled() && (cycles < most)) {
            read(frames);
            ++cycles;
        }
        return cycles;
    }

    void run_alone(int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            read(1);
            ASSERT_FALSE(rate.is_doubled()) << "cycle " << cycle;
        }
    }

    void start_anew() {
        rate = {};
        run_alone(200);
    }

    rsi::application::SenderRate rate;
};

TEST_F(ASenderRate, IsNotDoubledByOneSender) {
    run_alone(100'000);
}

TEST_F(ASenderRate, OfTwoSendersIsDoubledAfter120Milliseconds) {
    start_anew();
    EXPECT_EQ(cycles_until_doubled(2), 12);
}

// A few frames of a cycle are enough; that there are more proves no more.
TEST_F(ASenderRate, OfManyFramesIsDoubledAfter40MillisecondsHoweverManyTheyAre) {
    for (const int frames : {4, 5, 11, 64, 254}) {
        start_anew();
        EXPECT_EQ(cycles_until_doubled(frames), 4) << frames;
    }
    start_anew();
    EXPECT_EQ(cycles_until_doubled(3), 6);
}

TEST_F(ASenderRate, OfASecondSenderEvery80MillisecondsIsDoubledInTheEndAndOfOneEvery90Not) {
    for (const int every : {8, 9}) {
        start_anew();
        for (int cycle = 0; cycle < 10'000; ++cycle) {
            read((cycle % every == 0) ? 2 : 1);
        }
        EXPECT_EQ(rate.is_doubled(), every == 8);
    }
}

TEST_F(ASenderRate, IsSingleAgainWhenTheSurplusIsUsedUp) {
    start_anew();
    cycles_until_doubled(2);
    for (int cycle = 0; cycle < 59; ++cycle) {
        read(1);
        ASSERT_TRUE(rate.is_doubled()) << "cycle " << cycle;
    }
    read(1);
    EXPECT_FALSE(rate.is_doubled());
    EXPECT_EQ(cycles_until_doubled(2), 8);  // from zero, and not from the lower end
}

TEST_F(ASenderRate, SaturatesHoweverLongThereAreTwo) {
    for (int cycle = 0; cycle < 10'000; ++cycle) {
        read(64);
    }
    for (int cycle = 0; cycle < 60; ++cycle) {
        ASSERT_TRUE(rate.is_doubled()) << "cycle " << cycle;
        read(1);
    }
    EXPECT_FALSE(rate.is_doubled());
}

TEST_F(ASenderRate, IsSingleAfterASilence) {
    start_anew();
    cycles_until_doubled(2);
    pause(5);
    EXPECT_TRUE(rate.is_doubled());
    pause(1);
    EXPECT_FALSE(rate.is_doubled());
}

// A cycle finds none, two, or three of them: bus and cycle shift against each other.
TEST_F(ASenderRate, IsNotDoubledByFramesThatCycleAndBusShift) {
    constexpr std::array frames{0, 2, 1, 0, 0, 3, 1, 2, 0, 1, 2, 0, 1, 0, 2};
    for (std::size_t cycle = 0U; cycle < 10'000U; ++cycle) {
        read(frames[cycle % frames.size()]);
        ASSERT_FALSE(rate.is_doubled()) << "cycle " << cycle;
    }
}

TEST_F(ASenderRate, IsNotDoubledByTwoBursts) {
    start_anew();
    read(64);
    EXPECT_FALSE(rate.is_doubled());
    read(64);
    EXPECT_FALSE(rate.is_doubled());
    run_alone(100);
}

// All at once, or more than a cycle reads, or more cycles than there can be.
TEST_F(ASenderRate, IsNotDoubledByWhatIsReadAfterMissedCycles) {
    for (const std::uint32_t missed : {3U, 20U, 64U, 200U, std::numeric_limits<std::uint32_t>::max()}) {
        run_alone(200);
        int waiting = static_cast<int>(std::min(missed, 200U)) + 1;
        read(std::min(waiting, 21), missed);
        EXPECT_FALSE(rate.is_doubled()) << missed;
        for (waiting -= 21; waiting > 0; waiting -= 20) {
            read(std::min(waiting + 1, 21));
            EXPECT_FALSE(rate.is_doubled()) << missed;
        }
    }
}

TEST_F(ASenderRate, IsNotDoubledWhereEverySecondCycleIsMissed) {
    for (int cycle = 0; cycle < 10'000; ++cycle) {
        read(2, 1U);
        ASSERT_FALSE(rate.is_doubled()) << "cycle " << cycle;
    }
    int cycles = 0;
    for (; !rate.is_doubled() && (cycles < 100); ++cycles) {
        read(4, 1U);
    }
    EXPECT_LT(cycles, 30);
}

// They come beside the new ones when a delay of a tenth of a second ends at once.
TEST_F(ASenderRate, IsNotDoubledByFramesThatNewOnesOvertake) {
    run_alone(200);
    pause(10);
    run_alone(300);
    EXPECT_EQ(cycles_until_doubled(2, 10), 10);
    run_alone(100);
}

// Frames held up by the bus for 320 ms come afterwards, faster than it was sent.
TEST_F(ASenderRate, IsNotDoubledByFramesThatComeLaterAtAnySpeed) {
    for (const int first : {1, 2, 3}) {
        for (const int frames : {3, 4, 8, 32}) {
            run_alone(200);
            pause(31);
            read(first);
            for (int waiting = 32 - first; waiting > 0; waiting -= frames - 1) {
                read(std::min(frames, waiting + 1));
                ASSERT_FALSE(rate.is_doubled()) << first << ", " << frames;
            }
        }
    }
}

TEST_F(ASenderRate, RemembersASilenceAsLongAsItWas) {
    start_anew();
    pause(1);
    EXPECT_EQ(cycles_until_doubled(4), 4);  // 90 ms for 26 ms a cycle
    start_anew();
    pause(3);
    EXPECT_EQ(cycles_until_doubled(4), 5);
}

TEST_F(ASenderRate, RemembersNoMoreThan320MillisecondsOfAllSilences) {
    for (const int cycles : {27, 28, 32, 10'000}) {
        start_anew();
        pause(cycles);
        EXPECT_EQ(cycles_until_doubled(4), (cycles < 28) ? 14 : 15) << cycles;
    }
    for (const std::uint32_t missed : {27U, 28U, 29U, std::numeric_limits<std::uint32_t>::max()}) {
        start_anew();
        rate.miss(missed);
        EXPECT_EQ(cycles_until_doubled(4), (missed < 28U) ? 14 : 15) << missed;
    }
    start_anew();
    cycles_until_doubled(4);
    rate.miss(38U);  // from the upper end to the lower one
    read(3);
    EXPECT_FALSE(rate.is_doubled());
    EXPECT_EQ(cycles_until_doubled(3), 22);
}

TEST_F(ASenderRate, ForgetsASilenceWhenUpToTwoFramesComeInTheSecondCycleAfterIt) {
    for (const int frames : {1, 2, 3}) {
        start_anew();
        pause(32);
        read(1);
        read(frames);
        EXPECT_EQ(cycles_until_doubled(4), (frames <= 2) ? 4 : 14) << frames;
    }
}

// A missed cycle is a silence, too: what is read next does not end it, the cycle after it does.
TEST_F(ASenderRate, RemembersMissedCyclesUntilTheSecondFrameAfterThem) {
    start_anew();
    read(1, 32U);
    EXPECT_EQ(cycles_until_doubled(4), 15);
    start_anew();
    read(1, 32U);
    run_alone(1);
    EXPECT_EQ(cycles_until_doubled(4), 4);
}

// The time of their waiting is not known.
TEST_F(ASenderRate, IsNotDoubledByFramesThatWaitAtTheStart) {
    for (int cycle = 0; cycle < 12; ++cycle) {
        read(21);
        EXPECT_FALSE(rate.is_doubled());
    }
    run_alone(100);
    rate = {};
    EXPECT_EQ(cycles_until_doubled(2), 14);
    rate = {};
    EXPECT_EQ(cycles_until_doubled(11), 15);
}

}  // namespace
}  // namespace testing_application
