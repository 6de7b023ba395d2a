// The estimator's seat: which estimator runs when, and which may move the observer.
#include "rsi/estimation/roll_centre_estimator.hpp"

#include <gtest/gtest.h>

#include "tests/rsi/support/nominal.hpp"

namespace roll_centre_estimator_test {
namespace {

class AnEstimatorsSeat : public ::testing::Test {
 protected:
    void start(rsi_estimator estimator) {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.estimator = estimator;
        seat.init(parameters);
        model.init(parameters);
        fixed.reset(0.05F);
    }

    // A steady turn that leans more than the fixed roll centre explains.
    bool update(bool odd_sample) {
        rsi::Measurement measured;
        measured.road_parallel_force_mps2 = 5.0F;
        measured.road_normal_force_mps2 = 9.8F;
        measured.roll_angle_rad = 0.08F;
        measured.tan_roll_angle = 0.0802F;
        fixed.evaluate(model, measured);
        return seat.update(model, measured, fixed, 0.4F, 20.0F, odd_sample);
    }

    rsi::RollCentreEstimator seat;
    rsi::RollPlaneModel model;
    rsi::FixedModelRoll fixed;
};

// It drifts to where it fits anything.
TEST_F(AnEstimatorsSeat, LeavesTheObserverAloneWhileThePublishedEstimatorSitsThere) {
    start(RSI_ESTIMATOR_PUBLISHED);
    float before_m = 0.0F;
    for (int sample = 0; sample < 20; ++sample) {
        EXPECT_FALSE(update(sample % 2 != 0));
        EXPECT_NE(seat.estimate().vertical_movement_m, before_m) << sample;  // it runs in every sample
        before_m = seat.estimate().vertical_movement_m;
    }
}

TEST_F(AnEstimatorsSeat, MayMoveTheObserverInEvenSamplesWhileTheConsiderKalmanFilterSitsThere) {
    start(RSI_ESTIMATOR_CONSIDER_KALMAN);
    for (int sample = 0; sample < 20; ++sample) {
        const bool odd = (sample % 2 != 0);
        EXPECT_EQ(update(odd), !odd) << sample;
    }
}

}  // namespace
}  // namespace roll_centre_estimator_test
