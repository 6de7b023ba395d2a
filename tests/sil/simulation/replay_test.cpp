// Replay: the sensor frames of a run through the firmware again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>

#include "sil/simulation/replay.hpp"
#include "tests/sil/simulation/recorded_run.hpp"

namespace testing_simulation {
namespace {

TEST(AReplay, OfARunGivesTheFramesThatTheEcuSentByteForByte) {
    RunSettings settings;
    settings.noise = true;
    const RecordedRun run = run_and_record(hard_turn(), settings);
    const std::vector<sil::LoggedFrame> answers = sil::replay(run.log, large_suv_calibration());
    ASSERT_EQ(answers.size(), rsi::can_dbc::MessagesFromRolloverEcu::size * run.ecu_outputs.size());
    EXPECT_EQ(ecu_payloads(answers), ecu_payloads(run.log));
}

TEST(AReplay, BearsTheTimesOfTheRunAndItsInterface) {
    RunSettings settings;
    settings.duration_s = 1.0;
    const RecordedRun run = run_and_record(hard_turn(), settings);
    const std::vector<sil::LoggedFrame> answers = sil::replay(run.log, large_suv_calibration());
    for (std::size_t index = 0U; index < answers.size(); ++index) {
        ASSERT_EQ(
            answers[index].frame.receive_time.nanoseconds,
            static_cast<std::int64_t>(index / rsi::can_dbc::MessagesFromRolloverEcu::size) * 10'000'000);
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
        logged.frame.receive_time = logged.frame.receive_time + rsi::hal::Time{1'700'000'000'000'000'000};
    }
    EXPECT_EQ(ecu_payloads(sil::replay(run.log, large_suv_calibration())), expected);
}

sil::LoggedFrame frame_at(std::uint32_t identifier, std::int64_t time_ms, std::size_t line) {
    sil::LoggedFrame logged;
    logged.frame.identifier = identifier;
    logged.frame.length = 8U;
    logged.frame.receive_time = rsi::hal::Time::from_milliseconds(time_ms);
    logged.line = line;
    return logged;
}

TEST(AReplay, WithoutSensorFramesIsRefusedNamingTheIdentifiersExpected) {
    sil::LoggedFrame extended = frame_at(0x120U, 0, 2U);
    extended.frame.extended = true;
    for (const std::vector<sil::LoggedFrame>& log :
         {std::vector<sil::LoggedFrame>{}, {frame_at(0x0D0U, 0, 1U)}, {extended}}) {
        try {
            sil::replay(log, large_suv_calibration());
            FAIL() << "accepted";
        } catch (const sil::ReplayError& error) {
            EXPECT_EQ(error.line(), 0U);
            EXPECT_THAT(error.what(), ::testing::HasSubstr("0x120, 0x121, 0x122"));
        }
    }
}

TEST(AReplay, OfSensorFramesWhoseTimeGoesBackIsRefusedNamingTheLine) {
    try {
        sil::replay({frame_at(0x120U, 300, 4U), frame_at(0x121U, 250, 5U), frame_at(0x120U, 99, 7U)},
                    large_suv_calibration());
        FAIL() << "accepted";
    } catch (const sil::ReplayError& error) {
        EXPECT_EQ(error.line(), 7U);
        EXPECT_THAT(error.what(), ::testing::HasSubstr("from 0.300000 s to 0.099000 s"));
        EXPECT_THAT(error.what(), ::testing::HasSubstr("sort it by time"));
    }
}

// Recorders of several buses write the frames of each bus together.
TEST(AReplay, TakesFramesInTheOrderOfTheirTimes) {
    const std::vector<rsi::hal::CanFrame> frames = sil::replayable_frames(
        {frame_at(0x120U, 200, 1U), frame_at(0x121U, 205, 2U), frame_at(0x122U, 200, 3U),
         frame_at(0x120U, 5, 4U), frame_at(0x121U, 210, 5U)});
    const std::uint32_t identifiers[] = {0x120U, 0x120U, 0x122U, 0x121U, 0x121U};
    const std::int64_t times_ms[] = {5, 200, 200, 205, 210};
    ASSERT_EQ(frames.size(), 5U);
    for (std::size_t place = 0U; place < frames.size(); ++place) {
        EXPECT_EQ(frames[place].identifier, identifiers[place]);
        EXPECT_EQ(frames[place].receive_time.nanoseconds, times_ms[place] * 1'000'000);
    }
}

TEST(AReplay, OfADisorderedLogGivesTheSameAnswers) {
    RunSettings settings;
    settings.duration_s = 1.5;
    const RecordedRun run = run_and_record(hard_turn(), settings);
    const std::vector<std::string> expected = ecu_payloads(run.log);
    std::vector<sil::LoggedFrame> imu, disordered;  // those of the IMU twenty frames at a time, late
    for (const sil::LoggedFrame& logged : run.log) {
        (logged.frame.identifier == 0x120U ? imu : disordered).push_back(logged);
        if (imu.size() == 20U) {
            disordered.insert(disordered.end(), imu.begin(), imu.end());
            imu.clear();
        }
    }
    disordered.insert(disordered.end(), imu.begin(), imu.end());
    EXPECT_EQ(ecu_payloads(sil::replay(disordered, large_suv_calibration())), expected);
}

TEST(AReplay, OfTwoRecordingsOnClocksOfTheirOwnIsRefusedNamingTheLine) {
    try {
        sil::replay({frame_at(0x120U, 10, 1U), frame_at(0x120U, 3'700'000, 5U)}, large_suv_calibration());
        FAIL() << "accepted";
    } catch (const sil::ReplayError& error) {
        EXPECT_EQ(error.line(), 5U);
        EXPECT_THAT(error.what(), ::testing::HasSubstr("gap of 3700 s"));
    }
}

TEST(AReplay, OfALogForWhichThereIsNotEnoughMemoryIsRefusedNamingTheLine) {
    std::vector<sil::LoggedFrame> log;
    for (std::size_t line = 1U; line <= 14U; ++line) {
        log.push_back(frame_at(0x120U, static_cast<std::int64_t>(line) * 3'600'000, line));
    }
    try {
        sil::replay(log, large_suv_calibration());
        FAIL() << "accepted";
    } catch (const sil::ReplayError& error) {
        EXPECT_EQ(error.line(), 14U);
        EXPECT_THAT(error.what(), ::testing::HasSubstr("longer than 12 h; cut it in two before this line"));
    }
}

TEST(AReplay, AcceptsEqualTimesAndDisorderedFramesThatAreNotForTheFirmware) {
    const std::vector<sil::LoggedFrame> log{frame_at(0x120U, 10, 1U), frame_at(0x121U, 10, 2U),
                                            frame_at(0x0D0U, 0, 3U), frame_at(0x120U, 20, 4U)};
    EXPECT_EQ(sil::replay(log, large_suv_calibration()).size(),
              2U * rsi::can_dbc::MessagesFromRolloverEcu::size);
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
