// The choice of the estimator: which of them may move the observer.
#include "rsi/estimation/roll_centre_estimator.hpp"

#include <gtest/gtest.h>

#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/stages.hpp"

namespace roll_centre_estimator_test {
namespace {

class TheEstimatorInUse : public ::testing::Test {
 protected:
    void start(rsi_estimator estimator) {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.estimator = estimator;
        estimator_in_use.init(parameters);
        fixed.reset(0.05F);
    }

    // Straight, or a steady turn that leans more than the fixed roll centre explains.
    float update(float force_mps2 = 5.0F) {
        rsi::Measurement measured;
        measured.road_parallel_force_mps2 = force_mps2;
        measured.road_normal_force_mps2 = 9.8F;
        measured.roll_angle_rad = 0.016F * force_mps2;
        measured.tan_roll_angle = 0.01604F * force_mps2;
        fixed.update(estimator_in_use.vehicle, measured);
        return estimator_in_use.update(measured, fixed, 0.4F, 20.0F).vertical_movement_m;
    }

    rsi_test::RollCentreEstimator estimator_in_use;
    rsi::FixedModelRoll fixed;
};

// It drifts to where it fits anything.
TEST_F(TheEstimatorInUse, LeavesTheObserverAloneWhenItIsThePublishedOne) {
    start(RSI_ESTIMATOR_PUBLISHED);
    float before_m = 0.0F;
    for (int sample = 0; sample < 20; ++sample) {
        const float movement_m = update();
        EXPECT_NE(movement_m, before_m) << sample;
        EXPECT_EQ(estimator_in_use.movement_for_observer_m(), 0.0F) << sample;
        before_m = movement_m;
    }
}

TEST_F(TheEstimatorInUse, TellsTheObserverItsNewestMovementWhenItIsTheConsiderKalmanFilter) {
    start(RSI_ESTIMATOR_CONSIDER_KALMAN);
    int moved = 0;
    float before_m = 0.0F;
    for (int sample = 0; sample < 300; ++sample) {
        const float movement_m = update(sample < 200 ? 0.0F : 5.0F);
        EXPECT_EQ(estimator_in_use.movement_for_observer_m(), movement_m) << sample;
        moved += (movement_m != before_m) ? 1 : 0;
        before_m = movement_m;
    }
    EXPECT_GT(moved, 50);  // in every sample that teaches it something
}

// 6.7 % less of it explain all of that turn.
TEST_F(TheEstimatorInUse, TakesNoLoadThatIsKnownForAMovement) {
    const auto movement_m = [this](float mass_factor) {
        start(RSI_ESTIMATOR_CONSIDER_KALMAN);
        rsi::SprungBody body = rsi::calibrated_body(rsi_test::large_suv());
        body.mass_kg *= mass_factor;
        rsi::Vehicle& vehicle = estimator_in_use.vehicle;
        vehicle.loaded = rsi::loaded_body(vehicle.suspension, body);
        float result = 0.0F;
        for (int sample = 0; sample < 400; ++sample) {
            result = update(sample < 200 ? 0.0F : 5.0F);
        }
        return result;
    };
    EXPECT_GT(movement_m(1.0F), 0.03F);
    EXPECT_NEAR(movement_m(0.933F), 0.0F, 0.002F);
}

}  // namespace
}  // namespace roll_centre_estimator_test
