// A hard turn in sensor frames: ready, advisory, warning, on the side towards which the vehicle would fall.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/application/roll_plane_vehicle.hpp"

namespace testing_application {
namespace {

using State = rsi::can_dbc::RolloverWarning::State;
using Side = rsi::can_dbc::RolloverWarning::Side;

constexpr double g_mps2 = 9.80665;

// Straight for half a second, then 0.3 g more each second up to 0.85 g.
double hard_turn_mps2(double time_s) {
    return g_mps2 * std::clamp(0.3 * (time_s - 0.5), 0.0, 0.85);
}

// A bench after `seconds` of a hard turn, to the left with direction +1, and the vehicle's own truth.
struct Turn {
    Turn(double direction, double seconds) {
        bench.drive([this, direction](double time_s) {
            vehicle.advance(direction * hard_turn_mps2(time_s));
            truth_threshold.push_back(vehicle.threshold_mps2());
            truth_acceleration.push_back(vehicle.lateral_acceleration_mps2());
            return vehicle.motion();
        });
        bench.run_for(seconds);
    }

    std::size_t first(State state) const {
        const auto& cycles = bench.cycles();
        const auto found = std::find_if(cycles.begin(), cycles.end(),
                                        [state](const Cycle& cycle) { return cycle.state() == state; });
        return static_cast<std::size_t>(found - cycles.begin());
    }

    Bench bench;
    RollPlaneVehicle vehicle{large_suv()};
    std::vector<double> truth_threshold;
    std::vector<double> truth_acceleration;
};

TEST(GoodFrames, MakeTheEcuReadyAfterTheRecoveryTimeAndNotBefore) {
    Bench bench;
    bench.run_for(0.09);
    EXPECT_EQ(bench.state(), State::unavailable);
    bench.run_for(0.02);
    EXPECT_EQ(bench.state(), State::ready);
    EXPECT_EQ(bench.last().warning.value.side, Side::none);
}

TEST(GoodFrames, OfAStraightRoadNeverGiveMoreThanReady) {
    Bench bench;
    bench.run_until_ready();
    const std::size_t from = bench.cycles().size();
    bench.run_for(60.0);
    for (std::size_t index = from; index < bench.cycles().size(); ++index) {
        ASSERT_EQ(bench.cycles()[index].state(), State::ready) << "cycle " << index;
    }
    EXPECT_NEAR(static_cast<double>(bench.last().warning.value.warning_level), 0.0, 1.0e-3);
    EXPECT_EQ(bench.status().frames_rejected, 0U);
    EXPECT_EQ(bench.status().frames_lost, 0U);
}

TEST(AHardLeftTurn, GivesAdvisoryThenWarningOnTheRight) {
    const Turn turn{+1.0, 4.0};
    const std::size_t advisory = turn.first(State::advisory);
    const std::size_t warning = turn.first(State::warning);
    ASSERT_LT(advisory, turn.bench.cycles().size());
    ASSERT_LT(warning, turn.bench.cycles().size());
    EXPECT_LT(advisory, warning);
    EXPECT_EQ(turn.bench.cycles()[advisory].warning.value.side, Side::right);
    EXPECT_EQ(turn.bench.cycles()[warning].warning.value.side, Side::right);
}

// The roll centre of this vehicle does not move, so the indicator is a_y over the moment balance's threshold.
TEST(AHardLeftTurn, WarnsWhereTheMomentBalanceSays) {
    const Turn turn{+1.0, 4.0};
    const auto level_reached = [&turn](double level) {
        std::size_t index = 0U;
        while (turn.truth_acceleration.at(index) < level * turn.truth_threshold.at(index)) {
            ++index;
        }
        return index;
    };
    EXPECT_NEAR(static_cast<double>(turn.first(State::advisory)), static_cast<double>(level_reached(0.9)),
                2.0);
    EXPECT_NEAR(static_cast<double>(turn.first(State::warning)), static_cast<double>(level_reached(1.0)),
                4.0);
    EXPECT_NEAR(turn.truth_acceleration[turn.first(State::warning)] / g_mps2, 0.72, 0.02);
}

TEST(AHardLeftTurn, ShowsTheLateralAccelerationAndTheThresholdThatItWasComparedWith) {
    const Turn turn{+1.0, 4.0};
    for (std::size_t index = 100U; index < turn.bench.cycles().size(); ++index) {
        const rsi::can_dbc::RolloverWarning& warning = turn.bench.cycles()[index].warning.value;
        ASSERT_NEAR(static_cast<double>(warning.lateral_acceleration_mps2), turn.truth_acceleration[index],
                    0.05)
            << "cycle " << index;
        ASSERT_NEAR(static_cast<double>(warning.lateral_acceleration_threshold_mps2),
                    turn.truth_threshold[index], 0.02 * turn.truth_threshold[index])
            << "cycle " << index;
    }
}

TEST(AHardRightTurn, IsTheMirrorImageOfAHardLeftTurn) {
    const Turn left{+1.0, 4.0};
    const Turn right{-1.0, 4.0};
    ASSERT_LT(left.first(State::warning), left.bench.cycles().size());
    for (std::size_t index = 0U; index < left.bench.cycles().size(); ++index) {
        const Cycle& cycle = left.bench.cycles()[index];
        const Cycle& mirrored = right.bench.cycles()[index];
        ASSERT_EQ(cycle.state(), mirrored.state()) << "cycle " << index;
        const Side expected = cycle.warning.value.side == Side::right ? Side::left : Side::none;
        ASSERT_EQ(mirrored.warning.value.side, expected) << "cycle " << index;
    }
}

TEST(AWarning, EndsAfterItsHoldTimeWhenTheVehicleGoesStraightAgain) {
    Turn turn{+1.0, 4.0};
    ASSERT_EQ(turn.bench.state(), State::warning);
    turn.bench.drive([&turn](double) {
        turn.vehicle.advance(0.9 * turn.vehicle.lateral_acceleration_mps2());
        return turn.vehicle.motion();
    });
    turn.bench.run_for(3.0);
    EXPECT_EQ(turn.bench.state(), State::ready);
    EXPECT_EQ(turn.bench.last().warning.value.side, Side::none);
}

}  // namespace
}  // namespace testing_application
