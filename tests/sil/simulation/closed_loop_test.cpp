// The closed loop in one process: deterministic, complete, and the same to the left as to the right.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "tests/sil/simulation/recorded_run.hpp"

namespace testing_simulation {
namespace {

using sil::WarningSide;
using sil::WarningState;

// The identifiers of a cycle's frames, in their order: the sensors', then the ECU's.
std::vector<std::uint32_t> frames_of_a_cycle() {
    std::vector<std::uint32_t> frames{rsi::can_dbc::Imu::identifier, rsi::can_dbc::RollAngle::identifier,
                                      rsi::can_dbc::VehicleMotion::identifier};
    constexpr auto answers = rsi::can_dbc::MessagesFromRolloverEcu::identifiers;
    frames.insert(frames.end(), answers.begin(), answers.end());
    return frames;
}

std::set<WarningState> states_of(const RecordedRun& run) {
    std::set<WarningState> states;
    for (const sil::EcuOutput& output : run.ecu_outputs) {
        states.insert(output.state());
    }
    return states;
}

TEST(ARun, TwiceTheSameGivesTheSameLogByteForByte) {
    RunSettings settings;
    settings.noise = true;
    settings.seed = 7U;
    const RecordedRun first = run_and_record(hard_turn(), settings);
    const RecordedRun second = run_and_record(hard_turn(), settings);
    ASSERT_FALSE(first.log_text.empty());
    EXPECT_TRUE(first.log_text == second.log_text);
    EXPECT_EQ(states_of(first).count(WarningState::warning), 1U) << "the run is too tame to prove much";
}

TEST(ARun, WithAnotherSeedGivesOtherFrames) {
    RunSettings settings;
    settings.duration_s = 0.5;
    settings.noise = true;
    settings.seed = 7U;
    const RecordedRun first = run_and_record(hard_turn(), settings);
    settings.seed = 8U;
    const RecordedRun second = run_and_record(hard_turn(), settings);
    EXPECT_FALSE(first.log_text == second.log_text);
}

TEST(ARun, ExchangesTheFramesOfTheDbcFileEach10Milliseconds) {
    const std::vector<std::uint32_t> expected = frames_of_a_cycle();
    RunSettings settings;
    settings.duration_s = 2.0;
    const RecordedRun run = run_and_record(sil::find_manoeuvre("straight"), settings);
    ASSERT_EQ(run.log.size(), expected.size() * 201U);
    for (std::size_t index = 0U; index < run.log.size(); ++index) {
        ASSERT_EQ(run.log[index].frame.identifier, expected[index % expected.size()]) << index;
        ASSERT_EQ(run.log[index].frame.receive_time.nanoseconds,
                  static_cast<std::int64_t>(index / expected.size()) * 10'000'000)
            << index;
    }
    EXPECT_EQ(run.frames_refused, 0U);
}

TEST(ARun, MirroredHasTheSameStatesOnTheOtherSide) {
    RunSettings settings;
    const RecordedRun left = run_and_record(hard_turn(), settings);
    settings.mirrored = true;
    const RecordedRun right = run_and_record(hard_turn(), settings);
    ASSERT_EQ(states_of(left).count(WarningState::warning), 1U);
    ASSERT_EQ(left.events.warning_side, WarningSide::right);
    ASSERT_EQ(right.events.warning_side, WarningSide::left);
    EXPECT_NEAR(left.events.warning->time_s, right.events.warning->time_s, 0.0101);
    // A vehicle that rolls over ends its run.
    EXPECT_NEAR(static_cast<double>(left.ecu_outputs.size()), static_cast<double>(right.ecu_outputs.size()),
                2.0);
    const std::size_t cycles = std::min(left.ecu_outputs.size(), right.ecu_outputs.size());
    std::size_t differing = 0U;
    for (std::size_t index = 0U; index < cycles; ++index) {
        const sil::EcuOutput& output = left.ecu_outputs[index];
        const sil::EcuOutput& mirrored = right.ecu_outputs[index];
        const WarningSide expected = output.side() == WarningSide::none    ? WarningSide::none
                                     : output.side() == WarningSide::right ? WarningSide::left
                                                                           : WarningSide::right;
        differing += output.state() != mirrored.state() || mirrored.side() != expected ? 1U : 0U;
    }
    // The simulated vehicle's own rounding of left and right may move a change of state by a few
    // cycles: 2 % of them.
    EXPECT_LE(differing, cycles / 50U);
}

TEST(ARunOnAStraightRoad, IsReadyAndNothingElseAfterTheRecoveryTime) {
    RunSettings settings;
    settings.duration_s = 10.0;
    settings.noise = true;
    const RecordedRun run = run_and_record(sil::find_manoeuvre("straight"), settings);
    for (std::size_t index = 10U; index < run.ecu_outputs.size(); ++index) {
        ASSERT_EQ(run.ecu_outputs[index].state(), WarningState::ready) << index;
    }
    EXPECT_FALSE(run.events.warning.has_value());
}

TEST(EveryManoeuvreOfTheCatalogue, IsAnsweredInEachCycle) {
    const std::size_t frame_count = frames_of_a_cycle().size();
    for (const sil::Manoeuvre& manoeuvre : sil::all_manoeuvres()) {
        SCOPED_TRACE(manoeuvre.name);
        RunSettings settings;
        settings.duration_s = 2.0;
        const RecordedRun run = run_and_record(manoeuvre, settings);
        EXPECT_EQ(run.log.size(), frame_count * run.ecu_outputs.size());
        EXPECT_EQ(run.frames_refused, 0U);
        EXPECT_EQ(run.ecu_outputs.front().state(), WarningState::unavailable);
        EXPECT_EQ(run.ecu_outputs.at(20U).state(), WarningState::ready);
    }
}

}  // namespace
}  // namespace testing_simulation
