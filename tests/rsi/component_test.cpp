// The component as a whole, through its C++ interface.
#include "rsi/component.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "rsi/measurement/observer_gains.hpp"
#include "rsi/output_table.hpp"
#include "tests/rsi/support/body_kinematics.hpp"
#include "tests/rsi/support/damage.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/output_fields.hpp"
#include "tests/rsi/support/random_manoeuvre.hpp"

namespace component_test {
namespace {

using rsi_test::GroundMotion;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

class Scenario {
 public:
    explicit Scenario(const rsi_parameters& parameters = rsi_test::large_suv()) {
        EXPECT_EQ(component.init(parameters).accepted, 1);
    }
    const rsi_outputs& step(const rsi_inputs& inputs) {
        component.step(inputs, outputs);
        return outputs;
    }
    const rsi_outputs& run(double seconds, const rsi_inputs& inputs) {
        for (int k = 0; k < static_cast<int>(std::lround(seconds * 100.0)); ++k) {
            step(inputs);
        }
        return outputs;
    }
    rsi::Component component{};
    rsi_outputs outputs{};
};

rsi_inputs in_turn(double lateral_acceleration_mps2) {
    return rsi_test::sensed(
        GroundMotion{lateral_acceleration_mps2, 0.0, 0.0, lateral_acceleration_mps2 * 0.012});
}

// No roll sensor, and no speed either, so that the observer cannot stand in.
rsi_inputs without_roll_angle() {
    rsi_inputs inputs = rsi_test::at_rest();
    inputs.roll_angle_rad = nan;
    inputs.speed_mps = nan;
    return inputs;
}

TEST(Component, IsUnavailableBeforeItIsStarted) {
    rsi::Component component;
    rsi_outputs outputs{};
    component.step(rsi_test::at_rest(), outputs);
    EXPECT_EQ(outputs.state, RSI_STATE_UNAVAILABLE);
    EXPECT_TRUE(rsi_test::all_not_available(outputs));
}

TEST(Component, RefusedParametersLeaveItUnavailableAtEveryStep) {
    Scenario scenario;
    ASSERT_EQ(scenario.run(1.0, rsi_test::at_rest()).state, RSI_STATE_READY);
    rsi_parameters bad = rsi_test::large_suv();
    bad.track_width_m = nan;
    const rsi_validation answer = scenario.component.init(bad);
    EXPECT_EQ(answer.accepted, 0);
    EXPECT_STREQ(answer.field, "track_width_m");
    for (int k = 0; k < 500; ++k) {
        const rsi_outputs& outputs = scenario.step(rsi_test::at_rest());
        ASSERT_EQ(outputs.state, RSI_STATE_UNAVAILABLE);
        ASSERT_EQ(outputs.side, RSI_SIDE_NONE);
        ASSERT_TRUE(rsi_test::all_not_available(outputs));
    }
    EXPECT_EQ(scenario.component.init(rsi_test::large_suv()).accepted, 1);
    EXPECT_EQ(scenario.run(1.0, rsi_test::at_rest()).state, RSI_STATE_READY);
}

TEST(Component, StandingStillIsReadyWithoutRisk) {
    Scenario scenario;
    const rsi_outputs& outputs = scenario.run(10.0, rsi_test::at_rest());
    EXPECT_EQ(outputs.state, RSI_STATE_READY);
    EXPECT_EQ(outputs.side, RSI_SIDE_NONE);
    EXPECT_EQ(outputs.rsi, 0.0F);
    EXPECT_EQ(outputs.rsi_bank_free, 0.0F);
}

TEST(Component, AGentleTurnStaysReadyAndASharpOneWarnsOfTheOuterSide) {
    for (const double direction : {1.0, -1.0}) {
        Scenario scenario;
        EXPECT_EQ(scenario.run(3.0, in_turn(direction * 3.0)).state, RSI_STATE_READY);
        const rsi_outputs& outputs = scenario.run(1.0, in_turn(direction * 8.5));
        EXPECT_EQ(outputs.state, RSI_STATE_WARNING);
        EXPECT_EQ(outputs.side, (direction > 0.0) ? RSI_SIDE_RIGHT : RSI_SIDE_LEFT);
    }
}

// A slow left turn on a steep bank that falls to the left: the published form sees no risk, the bank-free one
// does.
TEST(Component, TheSelectedIndicatorDrivesTheWarning) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.advisory_on = parameters.advisory_off = 0.45F;
    const rsi_inputs inputs = rsi_test::sensed(GroundMotion{1.0, 0.0, -0.5, -0.05});
    for (const std::int32_t indicator : {RSI_INDICATOR_PUBLISHED, RSI_INDICATOR_BANK_FREE}) {
        parameters.warning_indicator = indicator;
        Scenario scenario(parameters);
        const rsi_outputs& outputs = scenario.run(0.5, inputs);
        ASSERT_LT(outputs.rsi, 0.4F);
        ASSERT_GT(outputs.rsi_bank_free, 0.5F);
        EXPECT_EQ(outputs.state,
                  (indicator == RSI_INDICATOR_PUBLISHED) ? RSI_STATE_READY : RSI_STATE_ADVISORY);
    }
}

// Here the threshold (23) is zero or negative, and (25) as printed says nothing.
TEST(Component, ABankThatOverturnsTheStandingVehicleIsWarnedOf) {
    for (const double bank : {0.70, 0.75, 0.79, -0.70, -0.75, -0.79}) {
        Scenario scenario;
        const rsi_inputs inputs = rsi_test::sensed(GroundMotion{0.0, 0.0, bank, (bank > 0.0) ? 0.1 : -0.1});
        const rsi_outputs& outputs = scenario.run(1.0, inputs);
        EXPECT_EQ(outputs.state, RSI_STATE_WARNING) << "bank " << bank;
        EXPECT_EQ(outputs.side, (bank > 0.0) ? RSI_SIDE_RIGHT : RSI_SIDE_LEFT) << "bank " << bank;
        EXPECT_EQ(outputs.rsi, 1.0F) << "bank " << bank;
    }
}

TEST(Component, ItsEstimatesOfAnOverturnedVehicleAreForgotten) {
    Scenario scenario;
    rsi_inputs on_its_side = in_turn(0.0);
    on_its_side.lateral_specific_force_mps2 = 9.8F;
    on_its_side.vertical_specific_force_mps2 = 0.5F;
    on_its_side.roll_angle_rad = 1.4F;
    ASSERT_EQ(scenario.run(5.0, on_its_side).state, RSI_STATE_WARNING);
    const rsi_outputs& outputs = scenario.run(0.5, in_turn(0.0));
    EXPECT_LT(std::abs(outputs.roll_stiffness_deviation_nmprad), 5000.0F);
    EXPECT_LT(std::abs(outputs.roll_centre_vertical_m), 0.05F);
}

TEST(Component, AMissingNecessaryInputIsUnavailableInTheSameStep) {
    for (float rsi_inputs::* const necessary : {&rsi_inputs::lateral_specific_force_mps2,
                                                &rsi_inputs::roll_rate_radps, &rsi_inputs::roll_angle_rad}) {
        Scenario scenario;
        ASSERT_EQ(scenario.run(1.0, in_turn(8.5)).state, RSI_STATE_WARNING);
        rsi_inputs inputs = in_turn(8.5);
        inputs.*necessary = nan;
        inputs.speed_mps = nan;  // or the observer would stand in for the roll sensor
        const rsi_outputs& outputs = scenario.step(inputs);
        EXPECT_EQ(outputs.state, RSI_STATE_UNAVAILABLE);
        EXPECT_EQ(outputs.side, RSI_SIDE_NONE);
        EXPECT_TRUE(rsi_test::all_not_available(outputs));
    }
}

// A steady turn at 20 m/s in which the suspension holds the body where the calibration says.
rsi_inputs in_steady_turn(double lateral_acceleration_mps2) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi_inputs inputs =
        rsi_test::sensed(GroundMotion{lateral_acceleration_mps2, 0.0, 0.0,
                                      rsi_test::held_roll_angle_rad(parameters, lateral_acceleration_mps2)});
    inputs.yaw_rate_radps = static_cast<float>(lateral_acceleration_mps2 / 20.0);
    inputs.speed_mps = 20.0F;
    inputs.bank_angle_rad = nan;
    return inputs;
}

TEST(Component, ALostRollSensorIsReplacedByTheObserverAndTheStateStays) {
    for (const double acceleration_mps2 : {3.0, -6.5}) {
        Scenario scenario;
        const rsi_inputs inputs = in_steady_turn(acceleration_mps2);
        const rsi_outputs with_sensor = scenario.run(3.0, inputs);
        ASSERT_NE(with_sensor.state, RSI_STATE_UNAVAILABLE);
        EXPECT_EQ(with_sensor.roll_source, RSI_ROLL_SENSOR);
        EXPECT_EQ(with_sensor.roll_sensor_disagrees, 0);
        rsi_inputs lost = inputs;
        lost.roll_angle_rad = nan;
        for (int k = 0; k < 500; ++k) {
            const rsi_outputs& outputs = scenario.step(lost);
            ASSERT_EQ(outputs.state, with_sensor.state) << k;
            ASSERT_EQ(outputs.roll_source, RSI_ROLL_OBSERVER) << k;
            ASSERT_NEAR(static_cast<double>(outputs.rsi), static_cast<double>(with_sensor.rsi), 0.03) << k;
        }
        EXPECT_EQ(scenario.step(inputs).roll_source, RSI_ROLL_SENSOR);
    }
}

TEST(Component, WarnsEarlierByTheMarginWhileTheObserverStandsIn) {
    const rsi_inputs inputs = in_steady_turn(5.0);
    rsi_inputs lost = inputs;
    lost.roll_angle_rad = nan;
    const float level = Scenario{}.run(3.0, inputs).warning_level;
    const float observed_level = Scenario{}.run(3.0, lost).warning_level;
    ASSERT_NEAR(observed_level, level, 0.02F);  // the published level is without the margin
    for (const float margin : {0.0F, 0.1F}) {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.observer_margin = margin;
        parameters.warning_on = 1.05F * level;
        parameters.warning_off = parameters.advisory_on = parameters.advisory_off = 1.04F * level;
        Scenario scenario{parameters};
        EXPECT_EQ(scenario.run(3.0, inputs).state, RSI_STATE_READY);
        EXPECT_EQ(scenario.run(1.0, lost).state, margin > 0.0F ? RSI_STATE_WARNING : RSI_STATE_READY);
    }
}

// The risk of the side that is named counts with the same margin as the other's: below the advisory level it
// must not keep its name.
TEST(Component, AHeldWarningNamesTheOtherSideOnceItHasAnAdvisorysRisk) {
    rsi_parameters parameters = rsi_test::large_suv();
    const float level = Scenario{}.run(3.0, in_steady_turn(5.0)).warning_level;
    parameters.warning_on = 1.2F * level;
    parameters.warning_off = parameters.advisory_on = parameters.advisory_off = 0.9F * level;
    parameters.warning_hold_s = 30.0F;
    Scenario scenario{parameters};
    const rsi_outputs first = scenario.run(3.0, in_steady_turn(6.5));
    ASSERT_EQ(first.state, RSI_STATE_WARNING);
    const rsi_outputs then = scenario.run(3.0, in_steady_turn(-5.0));
    ASSERT_LT(then.warning_level, parameters.warning_on);
    EXPECT_EQ(then.state, RSI_STATE_WARNING);
    EXPECT_NE(then.side, first.side);
    EXPECT_NE(then.side, RSI_SIDE_NONE);
}

TEST(Component, WithoutARollSensorFromTheStartItIsReadyOnceTheObserverKnows) {
    Scenario scenario;
    rsi_inputs inputs = in_steady_turn(4.0);
    inputs.roll_angle_rad = nan;
    EXPECT_EQ(scenario.step(inputs).state, RSI_STATE_UNAVAILABLE);
    EXPECT_EQ(scenario.step(inputs).roll_source, RSI_ROLL_NONE);
    const rsi_outputs& outputs = scenario.run(0.5, inputs);
    EXPECT_EQ(outputs.state, RSI_STATE_READY);
    EXPECT_EQ(outputs.roll_source, RSI_ROLL_OBSERVER);
}

TEST(Component, WithoutRollSensorAndWithoutSpeedOrYawRateItIsUnavailable) {
    for (float rsi_inputs::* const needed : {&rsi_inputs::speed_mps, &rsi_inputs::yaw_rate_radps}) {
        Scenario scenario;
        rsi_inputs inputs = in_steady_turn(3.0);
        inputs.roll_angle_rad = nan;
        ASSERT_EQ(scenario.run(1.0, inputs).state, RSI_STATE_READY);
        inputs.*needed = nan;
        const rsi_outputs& outputs = scenario.step(inputs);
        EXPECT_EQ(outputs.state, RSI_STATE_UNAVAILABLE);
        EXPECT_EQ(outputs.roll_source, RSI_ROLL_NONE);
        EXPECT_TRUE(rsi_test::all_not_available(outputs));
    }
}

TEST(Component, ARollSensorThatContradictsTheObserverIsReportedAndStaysInUse) {
    Scenario scenario;
    rsi_inputs inputs = in_steady_turn(6.5);
    ASSERT_EQ(scenario.run(3.0, inputs).roll_sensor_disagrees, 0);
    inputs.roll_angle_rad += 0.087F;  // 5 degrees
    EXPECT_EQ(scenario.run(0.25, inputs).roll_sensor_disagrees, 0);
    const rsi_outputs& outputs = scenario.run(0.15, inputs);  // 0.3 s are over
    EXPECT_EQ(outputs.roll_sensor_disagrees, 1);
    EXPECT_EQ(outputs.roll_source, RSI_ROLL_SENSOR);
    inputs.roll_angle_rad -= 0.087F;
    EXPECT_EQ(scenario.run(0.25, inputs).roll_sensor_disagrees, 1);
    EXPECT_EQ(scenario.run(0.15, inputs).roll_sensor_disagrees, 0);
}

TEST(Component, OptionalInputsMayBeMissing) {
    rsi_inputs inputs = in_turn(4.0);
    inputs.vertical_specific_force_mps2 = nan;
    inputs.yaw_rate_radps = nan;
    inputs.bank_angle_rad = nan;
    inputs.speed_mps = nan;
    Scenario scenario;
    const rsi_outputs& outputs = scenario.run(1.0, inputs);
    EXPECT_EQ(outputs.state, RSI_STATE_READY);
    EXPECT_TRUE(rsi_test::all_finite(outputs));
}

TEST(Component, AfterAGapTheModelsStartAtTheMeasuredAngleAndTheStateWaitsForRecovery) {
    Scenario scenario;
    scenario.run(2.0, in_turn(5.0));
    scenario.step(without_roll_angle());
    const rsi_inputs again = in_turn(-6.0);
    for (int k = 1; k <= 10; ++k) {  // recovery 0.1 s
        const rsi_outputs& outputs = scenario.step(again);
        if (k == 1) {
            EXPECT_EQ(outputs.fixed_model_roll_angle_rad, again.roll_angle_rad);
            EXPECT_EQ(outputs.compensated_roll_angle_rad, again.roll_angle_rad);
        }
        EXPECT_TRUE(rsi_test::all_finite(outputs));
        EXPECT_EQ(outputs.state == RSI_STATE_UNAVAILABLE, k < 10) << k;
    }
}

TEST(Component, TheEstimatorsLearningOutlivesAGap) {
    const rsi_parameters parameters = rsi_test::large_suv();
    Scenario scenario(parameters);
    rsi_test::RandomManoeuvre drive(parameters, 41U, false);
    rsi_inputs last{};
    for (int k = 0; k < 3000; ++k) {
        last = drive.next();
        scenario.step(last);
    }
    const float before = scenario.outputs.roll_centre_vertical_m;
    ASSERT_GT(std::fabs(before), 0.05F);
    scenario.step(without_roll_angle());
    scenario.step(last);
    EXPECT_NEAR(static_cast<double>(scenario.outputs.roll_centre_vertical_m), static_cast<double>(before),
                0.02);
}

TEST(Component, AnOverturnedVehicleWarnsWhateverTheAccelerationSays) {
    for (const float roll : {1.4F, -1.4F, 2.0F, -2.0F}) {
        Scenario scenario;
        rsi_inputs inputs = rsi_test::at_rest();
        inputs.roll_angle_rad = roll;
        inputs.vertical_specific_force_mps2 = 0.5F;
        inputs.lateral_specific_force_mps2 = 0.0F;
        const rsi_outputs& outputs = scenario.run(0.5, inputs);
        EXPECT_EQ(outputs.state, RSI_STATE_WARNING);
        EXPECT_EQ(outputs.side, (roll > 0.0F) ? RSI_SIDE_RIGHT : RSI_SIDE_LEFT);
    }
}

TEST(Component, StartingAgainForgetsEverything) {
    const rsi_parameters parameters = rsi_test::large_suv();
    Scenario used(parameters);
    rsi_test::RandomManoeuvre before(parameters, 43U, true);
    for (int k = 0; k < 2000; ++k) {
        used.step(before.next());
    }
    ASSERT_EQ(used.component.init(parameters).accepted, 1);
    Scenario fresh(parameters);
    rsi_test::RandomManoeuvre drive(parameters, 44U, true);
    for (int k = 0; k < 2000; ++k) {
        const rsi_inputs inputs = drive.next();
        ASSERT_TRUE(rsi_test::identical(used.step(inputs), fresh.step(inputs))) << k;
    }
}

// Left and right exchanged: the IMU on the other side, every lateral signal with the other sign.
TEST(Component, SaysWithOneThatItsEstimatorLearnsNothing) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.estimator = RSI_ESTIMATOR_CONSIDER_KALMAN;
    Scenario scenario{parameters};
    EXPECT_EQ(scenario.run(1.0, in_turn(6.0)).estimate_frozen, 1);  // no straight has been seen yet
}

// Drives both ways round in step.
void expect_mirrored(const rsi_parameters& parameters, const rsi_parameters& mirrored_parameters) {
    Scenario scenario(parameters);
    Scenario mirror(mirrored_parameters);
    rsi_test::RandomManoeuvre drive(parameters, 47U, true);
    int warnings = 0;
    for (int k = 0; k < 60000; ++k) {
        const rsi_inputs inputs = drive.next();
        rsi_inputs other = inputs;
        for (float rsi_inputs::* const lateral :
             {&rsi_inputs::lateral_specific_force_mps2, &rsi_inputs::roll_rate_radps,
              &rsi_inputs::roll_angle_rad, &rsi_inputs::yaw_rate_radps, &rsi_inputs::bank_angle_rad,
              &rsi_inputs::steering_wheel_angle_rad}) {
            other.*lateral = -(other.*lateral);
        }
        rsi_outputs expected = scenario.step(inputs);
        warnings += (expected.state == RSI_STATE_WARNING) ? 1 : 0;
        for (const rsi::NumberOutput& field : rsi::number_outputs) {
            float& value = expected.*field.member;
            // Adding zero makes -0 and +0 the same; not a number keeps its bits when it is not turned.
            const bool turns = (field.mirror == rsi::Mirror::turns);
            value = (turns && !std::isnan(value)) ? -value + 0.0F : value + 0.0F;
        }
        expected.side = (expected.side == RSI_SIDE_NONE)
                            ? RSI_SIDE_NONE
                            : ((expected.side == RSI_SIDE_LEFT) ? RSI_SIDE_RIGHT : RSI_SIDE_LEFT);
        rsi_outputs actual = mirror.step(other);
        for (const rsi::NumberOutput& field : rsi::number_outputs) {
            actual.*field.member += 0.0F;
        }
        ASSERT_TRUE(rsi_test::identical(expected, actual)) << "step " << k;
    }
    EXPECT_GT(warnings, 1000);
    EXPECT_LT(warnings, 59000);
}

TEST(Component, AMirroredManoeuvreGivesExactlyMirroredOutputs) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.imu_x_m = 0.5F;
    parameters.imu_y_m = 0.3F;
    parameters.imu_z_m = -0.4F;
    rsi_parameters mirrored_parameters = parameters;
    mirrored_parameters.imu_y_m = -parameters.imu_y_m;
    for (const rsi::IndexOutput& index : rsi::index_outputs) {
        parameters.warning_indicator = mirrored_parameters.warning_indicator = index.number;
        ASSERT_NO_FATAL_FAILURE(expect_mirrored(parameters, mirrored_parameters));
    }
    parameters.roll_angle_reference = mirrored_parameters.roll_angle_reference = RSI_ROLL_AGAINST_HORIZON;
    ASSERT_NO_FATAL_FAILURE(expect_mirrored(parameters, mirrored_parameters));
}

// A contradiction needs its whole time again after the sensor, or any necessary input, has been away.
TEST(Component, AContradictionOfTheRollSensorIsForgottenOverAGap) {
    for (float rsi_inputs::* const lost :
         {&rsi_inputs::roll_angle_rad, &rsi_inputs::speed_mps, &rsi_inputs::lateral_specific_force_mps2}) {
        Scenario scenario;
        rsi_inputs inputs = in_steady_turn(6.5);
        scenario.run(3.0, inputs);
        inputs.roll_angle_rad += 0.087F;
        ASSERT_EQ(scenario.run(0.4, inputs).roll_sensor_disagrees, 1);
        rsi_inputs gap = inputs;
        gap.*lost = nan;
        EXPECT_EQ(scenario.step(gap).roll_sensor_disagrees, 0);
        EXPECT_EQ(scenario.run(0.25, inputs).roll_sensor_disagrees, 0);
    }
}

// An overturn is forgotten once the vehicle stands again: what is learnt then outlives a gap as always.
TEST(Component, LearningAfterAnOverturnOutlivesAGap) {
    const rsi_parameters parameters = rsi_test::large_suv();
    Scenario scenario(parameters);
    rsi_inputs on_its_side = rsi_test::at_rest();
    on_its_side.roll_angle_rad = 1.4F;
    scenario.run(0.1, on_its_side);
    rsi_test::RandomManoeuvre drive(parameters, 41U, false);
    rsi_inputs last{};
    for (int k = 0; k < 3000; ++k) {
        last = drive.next();
        scenario.step(last);
    }
    const float before = scenario.outputs.roll_centre_vertical_m;
    ASSERT_GT(std::fabs(before), 0.05F);
    scenario.step(without_roll_angle());
    scenario.step(last);
    EXPECT_NEAR(static_cast<double>(scenario.outputs.roll_centre_vertical_m), static_cast<double>(before),
                0.02);
}

TEST(Component, TheFiltersEstimatesOfAnOverturnedVehicleAreForgottenToo) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.estimator = RSI_ESTIMATOR_CONSIDER_KALMAN;
    Scenario scenario(parameters);
    rsi_inputs learning = in_steady_turn(5.0);
    scenario.run(3.0, in_steady_turn(0.0));
    learning.roll_angle_rad *= 0.8F;
    scenario.run(2.0, learning);
    ASSERT_GT(std::fabs(scenario.outputs.roll_centre_vertical_m), 0.02F);
    rsi_inputs on_its_side = rsi_test::at_rest();
    on_its_side.roll_angle_rad = 1.4F;
    scenario.run(0.1, on_its_side);
    scenario.run(0.02, in_steady_turn(0.0));
    EXPECT_EQ(scenario.outputs.roll_centre_vertical_m, 0.0F);
}

// After any history, and with either estimator.
TEST(Component, AResetLeavesNothingOfBefore) {
    for (const rsi_estimator estimator : {RSI_ESTIMATOR_PUBLISHED, RSI_ESTIMATOR_CONSIDER_KALMAN}) {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.estimator = estimator;
        rsi::Component driven;
        ASSERT_EQ(driven.init(parameters).accepted, 1);
        rsi_test::RandomManoeuvre before(parameters, 51U, true);
        rsi_outputs of_driven;
        for (int k = 0; k < 3000; ++k) {
            driven.step(before.next(), of_driven);
        }
        driven.reset(parameters);
        rsi::Component fresh;
        ASSERT_EQ(fresh.init(parameters).accepted, 1);
        rsi_outputs of_fresh;
        rsi_test::RandomManoeuvre drive(parameters, 52U, true);
        for (int k = 0; k < 3000; ++k) {
            const rsi_inputs inputs = drive.next();
            driven.step(inputs, of_driven);
            fresh.step(inputs, of_fresh);
            ASSERT_EQ(std::memcmp(&of_driven, &of_fresh, sizeof of_fresh), 0) << k;
        }
    }
}

// Each byte in turn. Results of init's iteration are kept, so damage to it stays: the observer's gains and
// one angle.
TEST(Component, AResetRepairsAllOfTheComponentButWhatItKeeps) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi::Component sound;
    ASSERT_EQ(sound.init(parameters).accepted, 1);
    const rsi::Component as_initialised = sound;
    const auto answer = [](rsi::Component& component) {
        std::vector<rsi_outputs> outputs(30U);
        rsi_test::RandomManoeuvre drive(rsi_test::large_suv(), 53U, true);
        for (rsi_outputs& each : outputs) {
            component.step(drive.next(), each);
        }
        return outputs;
    };
    sound.reset(parameters);
    const std::vector<rsi_outputs> expected = answer(sound);
    const std::size_t kept = rsi_test::bytes_whose_damage_shows(as_initialised, [&](rsi::Component& damaged) {
        damaged.reset(parameters);
        const std::vector<rsi_outputs> answered = answer(damaged);
        return std::memcmp(answered.data(), expected.data(), expected.size() * sizeof(rsi_outputs)) == 0;
    });
    EXPECT_LE(kept, sizeof(rsi::ObserverGains) + sizeof(float));
}

TEST(Component, AResetForgetsThatItHasOverturned) {
    const rsi_parameters parameters = rsi_test::large_suv();
    Scenario scenario(parameters);
    scenario.run(2.0, in_steady_turn(5.0));
    rsi_inputs on_its_side = rsi_test::at_rest();
    on_its_side.roll_angle_rad = 1.4F;
    scenario.run(0.1, on_its_side);
    ASSERT_EQ(scenario.outputs.state, RSI_STATE_WARNING);
    scenario.component.reset(parameters);
    // A restored load does not count as learnt on the side.
    ASSERT_TRUE(scenario.component.restore_load({0.2F, 0.1F, 0.0F}, false));
    scenario.run(0.01, in_steady_turn(0.0));
    EXPECT_EQ(scenario.outputs.state, RSI_STATE_UNAVAILABLE);
    EXPECT_NEAR(scenario.component.learnt_load().excess, 0.2F, 0.01F);
}

TEST(Component, AResetDoesNotStartWhatWasRefused) {
    rsi_parameters refused = rsi_test::large_suv();
    refused.track_width_m = 0.0F;
    rsi::Component component;
    ASSERT_EQ(component.init(refused).accepted, 0);
    component.reset(rsi_test::large_suv());
    rsi_outputs outputs;
    component.step(in_steady_turn(0.0), outputs);
    EXPECT_EQ(outputs.roll_source, RSI_ROLL_NONE);
}

}  // namespace
}  // namespace component_test
