// Bus timing on logs of which the answer is known.
#include "sil/simulation/bus_timing.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace bus_timing_test {
namespace {

sil::LoggedFrame frame(std::uint32_t identifier, std::int64_t time_us) {
    sil::LoggedFrame logged;
    logged.frame.identifier = identifier;
    logged.frame.length = 8U;
    logged.frame.receive_time = rsi::hal::Time{time_us * 1000};
    logged.interface = "vcan0";
    return logged;
}

// `count` cycles of three sensor frames at 0, 100 and 200 us and a warning `reaction_us(cycle)` after the
// last.
template <typename Reaction>
std::vector<sil::LoggedFrame> cycles(int count, Reaction reaction_us) {
    std::vector<sil::LoggedFrame> log;
    for (int cycle = 0; cycle < count; ++cycle) {
        const std::int64_t start_us = 5'000'000 + 10'000 * cycle;
        log.push_back(frame(0x120U, start_us));
        log.push_back(frame(0x121U, start_us + 100));
        log.push_back(frame(0x122U, start_us + 200));
        log.push_back(frame(0x0D0U, start_us + 200 + reaction_us(cycle)));
        log.push_back(frame(0x230U, start_us + 300 + reaction_us(cycle)));
        log.push_back(frame(0x231U, start_us + 400 + reaction_us(cycle)));
    }
    return log;
}

TEST(BusTiming, OfAPunctualEcuIsWithoutJitterAndCountsFromTheLastSensorFrame) {
    const sil::BusTiming timing = sil::bus_timing(cycles(101, [](int) { return 1500; }));
    EXPECT_EQ(timing.warning_frames, 101U);
    EXPECT_NEAR(timing.duration_s, 1.0, 1.0e-9);
    EXPECT_NEAR(timing.cycle_jitter.value().largest_ms, 0.0, 1.0e-9);
    EXPECT_NEAR(timing.reaction_time.value().median_ms, 1.5, 1.0e-9);
    EXPECT_NEAR(timing.reaction_time.value().percentile_99_ms, 1.5, 1.0e-9);
    EXPECT_NEAR(timing.reaction_time.value().largest_ms, 1.5, 1.0e-9);
}

// Reactions of 1, 2, ... 200 times 10 us in a shuffled order (77 and 200 have no common divisor): half of
// them are at most 1 ms, 198 of 200 at most 1.98 ms.
TEST(BusTiming, GivesMedianPercentileAndLargestOfKnownReactions) {
    const sil::BusTiming timing =
        sil::bus_timing(cycles(200, [](int cycle) { return 10 * (77 * cycle % 200 + 1); }));
    EXPECT_NEAR(timing.reaction_time.value().median_ms, 1.0, 1.0e-9);
    EXPECT_NEAR(timing.reaction_time.value().percentile_99_ms, 1.98, 1.0e-9);
    EXPECT_NEAR(timing.reaction_time.value().largest_ms, 2.0, 1.0e-9);
}

// One frame 400 us late makes one cycle too long and the next too short: 2 of 100 distances deviate.
TEST(BusTiming, GivesTheJitterOfOneLateFrame) {
    const sil::BusTiming timing =
        sil::bus_timing(cycles(101, [](int cycle) { return cycle == 50 ? 1400 : 1000; }));
    EXPECT_NEAR(timing.cycle_jitter.value().median_ms, 0.0, 1.0e-9);
    EXPECT_NEAR(timing.cycle_jitter.value().percentile_99_ms, 0.4, 1.0e-9);
    EXPECT_NEAR(timing.cycle_jitter.value().largest_ms, 0.4, 1.0e-9);
}

TEST(BusTiming, CountsAMissingWarningAsJitterOfAWholeCycle) {
    std::vector<sil::LoggedFrame> log = cycles(11, [](int) { return 1000; });
    log.erase(log.begin() + 6 * 5 + 3);
    const sil::BusTiming timing = sil::bus_timing(log);
    EXPECT_EQ(timing.warning_frames, 10U);
    EXPECT_NEAR(timing.cycle_jitter.value().largest_ms, 10.0, 1.0e-9);
}

TEST(BusTiming, CountsEachSensorFrameForOneWarningOnly) {
    std::vector<sil::LoggedFrame> log = cycles(1, [](int) { return 1000; });
    log.push_back(frame(0x0D0U, 5'011'200));
    const sil::BusTiming timing = sil::bus_timing(log);
    EXPECT_NEAR(timing.reaction_time.value().largest_ms, 1.0, 1.0e-9);
}

std::string refusal_of(const std::vector<sil::LoggedFrame>& log) {
    try {
        sil::bus_timing(log);
    } catch (const sil::NoTiming& error) {
        return error.what();
    }
    return "accepted";
}

TEST(BusTiming, OfALogWithoutWarningFramesIsRefusedNamingTheFrame) {
    EXPECT_NE(refusal_of({}).find("0x0D0"), std::string::npos);
    EXPECT_NE(refusal_of({frame(0x120U, 1000), frame(0x121U, 2000)}).find("0x0D0"), std::string::npos);
}

TEST(BusTiming, OfALogInSimulatedTimeIsRefused) {
    std::vector<sil::LoggedFrame> log = cycles(11, [](int) { return 0; });
    log.push_back(frame(0x7F0U, 9'000'000));
    EXPECT_NE(refusal_of(log).find("no real times"), std::string::npos);
}

TEST(BusTiming, OfOneWarningFrameAloneHasNoFigures) {
    const sil::BusTiming timing = sil::bus_timing({frame(0x0D0U, 1000)});
    EXPECT_EQ(timing.warning_frames, 1U);
    EXPECT_FALSE(timing.cycle_jitter.has_value());
    EXPECT_FALSE(timing.reaction_time.has_value());
    EXPECT_EQ(sil::describe(timing).find("0.000"), std::string::npos);
}

TEST(BusTiming, IsDescribedWithItsFigures) {
    const std::string text = sil::describe(sil::bus_timing(cycles(101, [](int) { return 1500; })));
    EXPECT_NE(text.find("101 in 1.00 s"), std::string::npos) << text;
    EXPECT_NE(text.find("median 1.500 ms"), std::string::npos) << text;
}

}  // namespace
}  // namespace bus_timing_test
