// Replay: the sensor frames of a run through the firmware again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "sil/simulation/replay.hpp"
#include "tests/simulation/recorded_run.hpp"

namespace testing_simulation {
namespace {

TEST(AReplay, OfARunGivesTheFramesThatTheEcuSentByteForByte) {
    RunSettings settings;
    settings.noise = true;
    const RecordedRun run = run_and_record(hard_turn(), settings);
    const std::vector<sil::LoggedFrame> answers = sil::replay(run.log, large_suv_calibration());
    ASSERT_EQ(answers.size(), 3U * run.ecu_outputs.size());
    EXPECT_EQ(ecu_payloads(answers), ecu_payloads(run.log));
}

TEST(AReplay, BearsTheTimesOfTheRunAndItsInterface) {
    RunSettings settings;
    settings.duration_s = 1.0;
    const RecordedRun run = run_and_record(hard_turn(), settings);
    const std::vector<sil::LoggedFrame> answers = sil::replay(run.log, large_suv_calibration());
    for (std::size_t index = 0U; index < answers.size(); ++index) {
        ASSERT_EQ(answers[index].frame.receive_time.nanoseconds,
                  static_cast<std::int64_t>(index / 3U) * 10'000'000);
        ASSERT_EQ(answers[index].interface, "vcan0");
    }
}

// A log of the real bus starts at any time of day.
TEST(AReplay, DoesNotDependOnWhenTheLogWasRecorded) {
    RunSettings settings;
    settings.duration_s = 1.5;
    RecordedRun run = run_and_record(hard_turn(), settings);
    const std::vector<std::string> expected = ecu_payloads(run.log);
    for (sil::LoggedFrame& logged : run.log) {
        logged.frame.receive_time = logged.frame.receive_time + hal::Time{1'700'000'000'000'000'000};
    }
    EXPECT_EQ(ecu_payloads(sil::replay(run.log, large_suv_calibration())), expected);
}

TEST(AReplay, WithoutSensorFramesIsEmpty) {
    EXPECT_TRUE(sil::replay({}, large_suv_calibration()).empty());
    sil::LoggedFrame foreign;
    foreign.frame.identifier = 0x0D0U;
    foreign.frame.length = 8U;
    EXPECT_TRUE(sil::replay({foreign}, large_suv_calibration()).empty());
}

TEST(AReplay, WithRefusedParametersSaysWhichFieldIsWrong) {
    RunSettings settings;
    settings.duration_s = 0.1;
    const RecordedRun run = run_and_record(hard_turn(), settings);
    rsi::Parameters parameters = large_suv_calibration();
    parameters.track_width_m = 0.0F;
    try {
        sil::replay(run.log, parameters);
        FAIL() << "accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("track_width_m"));
    }
}

}  // namespace
}  // namespace testing_simulation
