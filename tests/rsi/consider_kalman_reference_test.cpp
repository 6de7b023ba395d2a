// The consider-Kalman filter in float against its equations in double, sample by sample, over a drive in
// which each of its bounds is passed: straights and turns of every sharpness, braking, bumps, near wheel
// lift.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rsi/estimation/consider_kalman.hpp"
#include "tests/rsi/support/inertial_roll_vehicle.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/recorded_like_signals.hpp"
#include "tests/rsi/support/reference_consider_kalman.hpp"
#include "tests/rsi/support/stages.hpp"

namespace consider_kalman_reference_test {
namespace {

double wide(float value) {
    return static_cast<double>(value);
}

// Ever sharper turns with straights between, to the left and to the right; every second one is entered
// slowly.
double force_mps2(double time_s) {
    const int turn = static_cast<int>(time_s / 8.0);
    const double within_s = time_s - 8.0 * turn;
    const double sharpness = ((turn % 2 == 0) ? 1.0 : -1.0) * (1.0 + 0.8 * (turn % 9));
    const double entered_s = (turn % 4 < 2) ? 0.6 : 2.5;
    return sharpness * std::clamp((within_s - 3.0) / entered_s, 0.0, 1.0) *
           std::clamp((8.0 - within_s) / 0.8, 0.0, 1.0);
}

// Braking and gathering speed, harder each time, around the 2.5 m/s^2 beyond which it counts.
double speed_mps(double time_s) {
    const double swing = std::sin(0.9 * time_s);
    return 25.0 + (2.0 + 0.02 * time_s) * swing;
}

struct Seen {
    int learning{0};
    int outliers{0};
    int held_near_lift{0};
};

Seen drive(const rsi_parameters& parameters, const rsi_test::InertialDeviation& deviation, int samples) {
    rsi_test::InertialRollVehicle vehicle(parameters, deviation);
    rsi_test::Noise noise(17U);
    rsi_test::ConsiderKalman filter;
    filter.init(parameters);
    rsi_test::ReferenceConsiderKalman reference(parameters);
    Seen seen;
    for (int k = 0; k < samples && !testing::Test::HasFailure(); ++k) {
        const double time_s = 0.01 * k;
        rsi::Measurement measured = vehicle.drive(force_mps2(time_s));
        const bool bump = (k % 331 < 3);
        measured.road_parallel_force_mps2 += static_cast<float>(noise(0.1) + (bump ? 4.0 : 0.0));
        measured.roll_rate_radps += static_cast<float>(noise(0.004));
        measured.roll_angle_rad += static_cast<float>(noise(0.002));
        measured.tan_roll_angle = std::tan(measured.roll_angle_rad);
        const auto extended_rsi = static_cast<float>(0.9 + 0.3 * std::sin(0.31 * time_s) - 0.2);
        const auto speed = static_cast<float>(speed_mps(time_s));
        const rsi::RollCentreEstimate estimate = filter.update(measured, extended_rsi, speed);
        reference.next(measured, wide(extended_rsi), wide(speed));
        EXPECT_NEAR(wide(estimate.vertical_movement_m), reference.movement_m(), 5.0e-5) << k;
        EXPECT_NEAR(wide(estimate.deviation_m), reference.deviation_m(), 5.0e-5) << k;
        EXPECT_NEAR(wide(estimate.disturbance_nm), reference.disturbance_nm(), 0.5) << k;
        EXPECT_EQ(estimate.frozen, reference.frozen()) << k;
        seen.learning += estimate.frozen ? 0 : 1;
        seen.outliers += reference.outlier() ? 1 : 0;
        seen.held_near_lift += (extended_rsi > parameters.freeze_level) ? 1 : 0;
    }
    return seen;
}

TEST(ConsiderKalman, FollowsItsEquationsOverADriveThatPassesItsBounds) {
    for (const double movement_m : {-0.06, 0.04}) {
        rsi_test::InertialDeviation deviation;
        deviation.vertical_m = movement_m;
        deviation.offset_mps2 = 0.15;
        const Seen seen = drive(rsi_test::large_suv(), deviation, 18000);
        EXPECT_GT(seen.learning, 3000);
        EXPECT_GT(seen.outliers, 400);
        EXPECT_GT(seen.held_near_lift, 2000);
    }
}

// With a memory so long and a limit so narrow that both ends of the variance, and the limit, are met.
TEST(ConsiderKalman, FollowsItsEquationsAtItsLimits) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.roll_centre_reversion_s = 1.0e4F;
    parameters.roll_centre_limit_m = 0.03F;
    parameters.roll_centre_prior_deviation_m = 0.01F;
    drive(parameters, {-0.08}, 10000);
    parameters.roll_centre_prior_deviation_m = 0.3F;
    drive(parameters, {-0.08}, 10000);
}

// A turn that begins while the offset is hardly known, or just known.
TEST(ConsiderKalman, LearnsATurnFromTheSampleInWhichItsEquationsDo) {
    const rsi_parameters parameters = rsi_test::large_suv();
    int learnt = 0;
    for (int straight = 24; straight < 80; ++straight) {
        rsi_test::InertialRollVehicle vehicle(parameters, {-0.05});
        rsi_test::ConsiderKalman filter;
        filter.init(parameters);
        rsi_test::ReferenceConsiderKalman reference(parameters);
        for (int k = 0; k < 120; ++k) {
            const double force = (k < straight) ? 0.0 : 6.0;
            const rsi::Measurement measured = vehicle.drive(force);
            const rsi::RollCentreEstimate estimate = filter.update(measured, 0.0F, 20.0F);
            reference.next(measured, 0.0, 20.0);
            ASSERT_EQ(estimate.frozen, reference.frozen()) << straight << ' ' << k;
            learnt += estimate.frozen ? 0 : 1;
        }
    }
    EXPECT_GT(learnt, 400);
    EXPECT_LT(learnt, 3200);
}

}  // namespace
}  // namespace consider_kalman_reference_test
