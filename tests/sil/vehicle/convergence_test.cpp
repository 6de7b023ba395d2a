// Convergence: results belong to the vehicle, not to the step size.
#include <gtest/gtest.h>
#include <cmath>

#include "scenario.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"

namespace {

double roll_in_j_turn(double step_s) {
    sil::RunOptions options;
    options.step_s = step_s;
    options.duration_s = 1.5;
    sil::ManoeuvreRun run{scenario::large_suv(), sil::find_manoeuvre("j-turn-110"), options};
    while (!run.finished()) {
        run.step();
    }
    return run.truth().roll_angle_rad;
}

TEST(Convergence, TheErrorOfTheRollAngleHalvesWithTheStep) {
    const double reference = roll_in_j_turn(1.0 / 16000.0);
    const double coarse = std::abs(roll_in_j_turn(1.0 / 1000.0) - reference);
    const double medium = std::abs(roll_in_j_turn(1.0 / 2000.0) - reference);
    const double fine = std::abs(roll_in_j_turn(1.0 / 4000.0) - reference);
    // First order: e(h) - e(reference) gives the ratios 15/7 and 7/3.
    EXPECT_NEAR(coarse / medium, 15.0 / 7.0, 0.3);
    EXPECT_NEAR(medium / fine, 7.0 / 3.0, 0.4);
    EXPECT_LT(coarse, 0.001);
}

TEST(Convergence, TwoWheelLiftOffMovesByAtMostTwoMillisecondsBetweenCoarseAndFineSteps) {
    const sil::Manoeuvre manoeuvre = sil::find_manoeuvre("j-turn-110");
    sil::RunOptions options;
    options.duration_s = 2.5;
    const double coarse = scenario::drive(scenario::large_suv(), manoeuvre, options).two_wheel_lift_s;
    options.step_s = 0.000125;
    const double fine = scenario::drive(scenario::large_suv(), manoeuvre, options).two_wheel_lift_s;
    ASSERT_NE(coarse, scenario::not_yet);
    ASSERT_NE(fine, scenario::not_yet);
    EXPECT_NEAR(coarse, fine, 0.002);
}

TEST(Repeatability, TheSameRunTwiceIsTheSameToTheLastBit) {
    const sil::Manoeuvre manoeuvre = sil::find_manoeuvre("j-turn-110");
    sil::ManoeuvreRun first{scenario::large_suv(), manoeuvre};
    sil::ManoeuvreRun second{scenario::large_suv(), manoeuvre};
    while (!first.finished()) {
        first.step();
        second.step();
        ASSERT_EQ(first.truth().roll_angle_rad, second.truth().roll_angle_rad);
        ASSERT_EQ(first.truth().wheel_load_n, second.truth().wheel_load_n);
        ASSERT_EQ(first.truth().specific_force_mps2, second.truth().specific_force_mps2);
    }
}

}  // namespace
