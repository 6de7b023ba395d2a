// Sine with dwell: amplitudes of a series, and what is measured of a yaw rate that is known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "sil/studies/procedures/sine_with_dwell.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/rule_book.hpp"
#include "tests/sil/procedures/shipped_world.hpp"

namespace {

constexpr double completion_s = sil::SineWithDwell::completion_s;

TEST(SineWithDwellAmplitudes, GrowByHalfAToTwoHundredAndSeventyDegreesAtLeast) {
    EXPECT_THAT(sil::sine_with_dwell_amplitudes_deg(40.0),
                testing::ElementsAre(60.0, 80.0, 100.0, 120.0, 140.0, 160.0, 180.0, 200.0, 220.0, 240.0,
                                     260.0, 270.0));
}

TEST(SineWithDwellAmplitudes, EndAtSixAndAHalfAOrThreeHundredDegreesIfThatIsLess) {
    EXPECT_DOUBLE_EQ(sil::sine_with_dwell_amplitudes_deg(44.0).back(), 286.0);
    EXPECT_EQ(sil::sine_with_dwell_amplitudes_deg(44.0).size(), 11U);
    EXPECT_DOUBLE_EQ(sil::sine_with_dwell_amplitudes_deg(60.0).back(), 300.0);
    EXPECT_DOUBLE_EQ(sil::sine_with_dwell_amplitudes_deg(60.0).front(), 90.0);
}

// Drives the measurement with a yaw rate to the right and a lateral position over time.
void feed(sil::SineWithDwellMeasurement& measurement, const std::function<double(double)>& yaw_rate,
          double end_s = completion_s + 2.0) {
    for (int step = 1; step * 0.001 < end_s; ++step) {
        sil::Truth truth;
        truth.time_s = step * 0.001;
        truth.speed_mps = 22.0;
        truth.wheel_load_n = {1.0, 1.0, 1.0, 1.0};
        truth.steering_wheel_angle_rad = truth.time_s > 2.0105 ? 6.0 / sil::degrees_per_radian : 0.0;
        truth.position_y_m = 10.0 * truth.time_s;
        truth.angular_velocity_radps[2] = -yaw_rate(truth.time_s);
        measurement.step(truth);
    }
}

TEST(SineWithDwellMeasurement, TakesSharesOfTheFirstPeakAfterTheChangeOfSign) {
    sil::SineWithDwellMeasurement measurement;
    feed(measurement, [](double time_s) {
        if (time_s < sil::SineWithDwell::sign_change_s + 0.1) {
            return -0.9;  // still of the first turn
        }
        if (time_s < completion_s) {
            return time_s < 3.2 ? 0.5 : (time_s < 3.4 ? 0.4 : 0.8);  // the second peak does not count
        }
        return time_s < completion_s + 1.5 ? 0.15 : -0.05;
    });
    ASSERT_TRUE(measurement.peak_yaw_rate_radps());
    EXPECT_DOUBLE_EQ(*measurement.peak_yaw_rate_radps(), 0.5);
    EXPECT_NEAR(*measurement.share_after_1_00_s(), 30.0, 1e-9);
    EXPECT_NEAR(*measurement.share_after_1_75_s(), -10.0, 1e-9);
    EXPECT_NEAR(*measurement.displacement_m(), 10.7, 1e-6);
    EXPECT_TRUE(measurement.finished());
}

TEST(SineWithDwellMeasurement, MeasuresAtItsMomentsToTheStep) {
    for (const double after_s : {1.0, 1.75}) {
        sil::SineWithDwellMeasurement measurement;
        feed(measurement, [after_s](double time_s) {
            return std::abs(time_s - completion_s - after_s) < 0.0011 ? 0.2 : 1.0;
        });
        const auto share =
            after_s < 1.5 ? measurement.share_after_1_00_s() : measurement.share_after_1_75_s();
        EXPECT_NEAR(share.value_or(-1.0), 20.0, 1e-9) << after_s;
    }
}

TEST(SineWithDwellMeasurement, HasNothingOfARunThatEndedBefore) {
    sil::SineWithDwellMeasurement measurement;
    feed(measurement, [](double) { return 0.5; }, completion_s + 1.2);
    EXPECT_TRUE(measurement.share_after_1_00_s());
    EXPECT_FALSE(measurement.share_after_1_75_s());
    EXPECT_FALSE(measurement.finished());
}

TEST(SineWithDwellCriteria, HaveTheLimitsOfTheRuleAndThatOfTheVehiclesMass) {
    const sil::SineWithDwellMeasurement measurement;
    const auto light = sil::sine_with_dwell_criteria(measurement, 3500.0, true);
    ASSERT_EQ(light.size(), 3U);
    EXPECT_EQ(light[0].limit, 35.0);
    EXPECT_EQ(light[1].limit, 20.0);
    EXPECT_EQ(light[0].bound, sil::Bound::at_most);
    EXPECT_EQ(light[2].bound, sil::Bound::at_least);
    EXPECT_EQ(light[2].limit, 1.83);
    EXPECT_EQ(sil::sine_with_dwell_criteria(measurement, 3501.0, true)[2].limit, 1.52);
    EXPECT_TRUE(light[2].asked);
    EXPECT_FALSE(sil::sine_with_dwell_criteria(measurement, 3500.0, false)[2].asked);
}

TEST(SineWithDwellProcedure, AsksForTheDisplacementFromFiveAOnAndEndsASeriesWhenTheVehicleOverturns) {
    const sil::ProcedureResult result =
        sil::find_procedure("sine-with-dwell").run(testing_procedures::shipped("large_suv"));
    for (const sil::ProcedureStep& step : result.steps) {
        EXPECT_EQ(step.criteria[2].asked, *step.figures[1].value >= 5.0 - 1e-9) << step.name;
    }
    EXPECT_EQ(result.outcome, sil::ProcedureOutcome::not_met);
    EXPECT_FALSE(result.steps.back().criteria[1].measured.value);
    EXPECT_LT(*result.steps.back().figures[0].value, 270.0);
    const sil::ProcedureResult stays_up =
        sil::find_procedure("sine-with-dwell").run(testing_procedures::shipped("ordinary_suv"));
    EXPECT_NEAR(*stays_up.steps.back().figures[0].value, 270.0, 1e-9);
}

}  // namespace
