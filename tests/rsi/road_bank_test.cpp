// A roll angle against the horizon: what is made of it on banked roads, with and without a bank sensor.
#include "rsi/measurement/road_bank.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rsi/measurement/measurement.hpp"
#include "tests/rsi/support/banked_drive.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/stages.hpp"

namespace road_bank_test {
namespace {

using rsi_test::Drive;
using rsi_test::RollingVehicle;

constexpr double degrees_per_radian = 180.0 / rsi_test::pi;
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

constexpr int known_after = 20;  // samples: a fifth of a second, as the observer itself

rsi_parameters horizon_vehicle() {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.roll_angle_reference = RSI_ROLL_AGAINST_HORIZON;
    return parameters;
}

rsi_test::MeasurementStage stage_of(const rsi_parameters& parameters) {
    rsi_test::MeasurementStage stage;
    stage.init(parameters);
    return stage;
}

rsi_inputs against_horizon(const RollingVehicle& vehicle) {
    rsi_inputs inputs = vehicle.inputs();
    inputs.roll_angle_rad += static_cast<float>(vehicle.bank_angle_rad());
    return inputs;
}

// A drive of 20 s, each sample of which may be changed before it is measured.
struct Seen {
    double largest_error_deg{0.0};  // of the roll angle, after the first second
    int without_sensor{0};          // samples after the start
    int disagreements{0};
};

template <typename Change>
Seen drive(const rsi_parameters& parameters, const Drive& course, Change change) {
    RollingVehicle vehicle{rsi_test::large_suv(), course};
    rsi_test::MeasurementStage stage = stage_of(parameters);
    Seen seen;
    for (int k = 1; k <= 2000; ++k) {
        vehicle.advance_10_ms();
        rsi_inputs inputs = against_horizon(vehicle);
        change(k, inputs, vehicle);
        rsi::Measurement measured;
        const bool known = stage.update(inputs, measured);
        if (k <= known_after) {
            continue;
        }
        seen.without_sensor += (known && measured.roll_source == RSI_ROLL_SENSOR) ? 0 : 1;
        seen.disagreements += measured.observed.sensor_disagrees ? 1 : 0;
        if (k > 100) {
            const double error = static_cast<double>(measured.roll_angle_rad) - vehicle.roll_angle_rad();
            seen.largest_error_deg = std::fmax(seen.largest_error_deg, degrees_per_radian * std::fabs(error));
        }
    }
    return seen;
}

Seen drive(const rsi_parameters& parameters, const Drive& course) {
    return drive(parameters, course, [](int, rsi_inputs&, const RollingVehicle&) {});
}

Drive onto_a_bank(double bank_deg) {
    Drive course;
    course.bank_rad = bank_deg / degrees_per_radian;
    return course;
}

Drive slalom_onto_a_bank(double bank_deg) {
    Drive course = onto_a_bank(bank_deg);
    course.largest_acceleration_mps2 = 5.0;
    return course;
}

TEST(AngleAgainstTheHorizon, IsTheOneAgainstTheRoadLessTheBankThatIsMeasured) {
    for (const double bank_deg : {8.0, -8.0}) {
        const Seen seen = drive(horizon_vehicle(), slalom_onto_a_bank(bank_deg),
                                [](int, rsi_inputs& inputs, const RollingVehicle& vehicle) {
                                    inputs.bank_angle_rad = static_cast<float>(vehicle.bank_angle_rad());
                                });
        EXPECT_LT(seen.largest_error_deg, 1.0e-4);
        EXPECT_EQ(seen.without_sensor, 0);
        EXPECT_EQ(seen.disagreements, 0);
    }
}

TEST(AngleAgainstTheHorizon, LosesTheBankWithoutABankSensorToo) {
    for (const double bank_deg : {8.0, -8.0}) {
        for (const Drive& course : {onto_a_bank(bank_deg), slalom_onto_a_bank(bank_deg)}) {
            const Seen seen = drive(horizon_vehicle(), course);
            EXPECT_LT(seen.largest_error_deg, 2.5);
            EXPECT_EQ(seen.without_sensor, 0);
            EXPECT_EQ(seen.disagreements, 0);
        }
    }
}

TEST(AngleAgainstTheHorizon, TakenForOneAgainstTheRoadContainsTheBank) {
    const Seen seen = drive(rsi_test::large_suv(), onto_a_bank(8.0));
    EXPECT_GT(seen.largest_error_deg, 7.9);
    EXPECT_GT(seen.disagreements, 1000);
}

// The sensor, not the model, shows what is quick: the body of a vehicle that rolls a fifth more than its
// calibration says is seen to do so.
TEST(AngleAgainstTheHorizon, ShowsARollThatTheCalibrationDoesNotExpect) {
    rsi_parameters stiffer = horizon_vehicle();
    stiffer.roll_stiffness_nmprad *= 1.2F;
    RollingVehicle vehicle{rsi_test::large_suv(), slalom_onto_a_bank(0.0)};
    rsi_test::MeasurementStage stage = stage_of(stiffer);
    double sensed = 0.0;
    double observed = 0.0;
    for (int k = 1; k <= 2000; ++k) {
        vehicle.advance_10_ms();
        rsi::Measurement measured;
        if (stage.update(against_horizon(vehicle), measured) && k > 100) {
            sensed += std::fabs(static_cast<double>(measured.roll_angle_rad) - vehicle.roll_angle_rad());
            observed +=
                std::fabs(static_cast<double>(measured.observed.roll_angle_rad) - vehicle.roll_angle_rad());
        }
    }
    EXPECT_LT(sensed, 0.75 * observed);
}

TEST(AngleAgainstTheHorizon, AnOffsetOfTheSensorDoesNotGetThrough) {
    const Seen seen =
        drive(horizon_vehicle(), slalom_onto_a_bank(6.0),
              [](int, rsi_inputs& inputs, const RollingVehicle&) { inputs.roll_angle_rad += 0.1F; });
    EXPECT_LT(seen.largest_error_deg, 1.9);
    EXPECT_EQ(seen.disagreements, 0);
}

TEST(AngleAgainstTheHorizon, ABankSteeperThanAnyRoadIsASensorThatDisagrees) {
    const auto off_by = [](float offset_rad) {
        return drive(horizon_vehicle(), Drive{},
                     [offset_rad](int, rsi_inputs& inputs, const RollingVehicle&) {
                         inputs.roll_angle_rad += offset_rad;
                     })
            .disagreements;
    };
    EXPECT_EQ(off_by(0.41F), 0);
    EXPECT_EQ(off_by(-0.41F), 0);
    EXPECT_GT(off_by(0.48F), 1900);
    EXPECT_GT(off_by(-0.48F), 1900);
}

TEST(AngleAgainstTheHorizon, IsKnownWithinAFifthOfASecondAndNotBefore) {
    RollingVehicle vehicle{rsi_test::large_suv(), Drive{}};
    rsi_test::MeasurementStage stage = stage_of(horizon_vehicle());
    rsi::Measurement measured;
    for (int gap = 0; gap < 2; ++gap) {
        ASSERT_FALSE(stage.update(against_horizon(vehicle), measured));
        for (int k = 0; k < known_after; ++k) {
            stage.update(against_horizon(vehicle), measured);
        }
        EXPECT_TRUE(stage.update(against_horizon(vehicle), measured));
        EXPECT_EQ(measured.roll_source, RSI_ROLL_SENSOR);
        rsi_inputs lost = against_horizon(vehicle);
        lost.roll_rate_radps = nan;
        EXPECT_FALSE(stage.update(lost, measured));
    }
}

TEST(AngleAgainstTheHorizon, WithABankSensorIsKnownFromTheFirstSample) {
    rsi_inputs inputs = rsi_test::at_rest();
    inputs.roll_angle_rad = 0.12F;
    inputs.bank_angle_rad = 0.1F;
    rsi_test::MeasurementStage stage = stage_of(horizon_vehicle());
    rsi::Measurement measured;
    ASSERT_TRUE(stage.update(inputs, measured));
    EXPECT_FLOAT_EQ(measured.roll_angle_rad, 0.12F - 0.1F);
}

// An angle without the observer's bank is, in the end, the observer's: no load can be learnt from
// it.
TEST(AngleAgainstTheHorizon, IsAMeasuredOneOnlyWithABankSensor) {
    rsi_inputs inputs = rsi_test::at_rest();
    for (const bool horizon : {false, true}) {
        for (const float bank_rad : {nan, 0.02F}) {
            rsi_test::MeasurementStage stage = stage_of(horizon ? horizon_vehicle() : rsi_test::large_suv());
            inputs.bank_angle_rad = bank_rad;
            rsi::Measurement measured;
            for (int k = 0; k <= known_after; ++k) {
                stage.update(inputs, measured);
            }
            ASSERT_EQ(measured.roll_source, RSI_ROLL_SENSOR);
            EXPECT_EQ(measured.roll_angle_is_measured, !horizon || std::isfinite(bank_rad));
            inputs.roll_angle_rad = nan;
            stage.update(inputs, measured);
            EXPECT_FALSE(measured.roll_angle_is_measured);
            inputs.roll_angle_rad = 0.0F;
        }
    }
}

// The suspension shows the roll without a motion signal, but the observer does not stand in for the sensor
// then.
TEST(AngleAgainstTheHorizon, NeedsNeitherSpeedNorYawRate) {
    for (float rsi_inputs::* missing : {&rsi_inputs::speed_mps, &rsi_inputs::yaw_rate_radps}) {
        const Seen seen =
            drive(horizon_vehicle(), onto_a_bank(6.0),
                  [missing](int, rsi_inputs& inputs, const RollingVehicle&) { inputs.*missing = nan; });
        EXPECT_LT(seen.largest_error_deg, 1.2);
        EXPECT_EQ(seen.without_sensor, 0);

        rsi_test::MeasurementStage stage = stage_of(horizon_vehicle());
        rsi::Measurement measured;
        rsi_inputs inputs = rsi_test::at_rest();
        inputs.bank_angle_rad = nan;
        inputs.*missing = nan;
        for (int k = 0; k < 100; ++k) {
            stage.update(inputs, measured);
        }
        EXPECT_TRUE(stage.update(inputs, measured));
        inputs.roll_angle_rad = nan;
        EXPECT_FALSE(stage.update(inputs, measured));
    }
}

TEST(AngleAgainstTheHorizon, AStartForgetsTheBank) {
    rsi_test::MeasurementStage stage = stage_of(horizon_vehicle());
    rsi::Measurement measured;
    rsi_inputs inputs = rsi_test::at_rest();
    inputs.bank_angle_rad = nan;
    for (int k = 0; k < 100; ++k) {
        stage.update(inputs, measured);
    }
    ASSERT_TRUE(stage.update(inputs, measured));
    stage.init(horizon_vehicle());
    EXPECT_FALSE(stage.update(inputs, measured));
}

TEST(AngleAgainstTheHorizon, ABankBeforeAGapOfTheSensorIsForgotten) {
    rsi_test::MeasurementStage stage = stage_of(horizon_vehicle());
    rsi::Measurement measured;
    rsi_inputs inputs = rsi_test::at_rest();
    inputs.bank_angle_rad = nan;
    inputs.speed_mps = 20.0F;
    for (int k = 0; k < 100; ++k) {
        stage.update(inputs, measured);
    }
    inputs.roll_angle_rad = nan;
    ASSERT_TRUE(stage.update(inputs, measured));
    EXPECT_EQ(measured.roll_source, RSI_ROLL_OBSERVER);
    inputs.roll_angle_rad = 0.1F;  // as if the road had banked meanwhile
    ASSERT_TRUE(stage.update(inputs, measured));
    EXPECT_EQ(measured.roll_source, RSI_ROLL_SENSOR);
    EXPECT_NEAR(measured.roll_angle_rad, 0.0F, 1.0e-6F);
}

// While the inner wheels are up the observer only integrates the gyro; the sensor goes on.
TEST(AngleAgainstTheHorizon, KeepsTheBankWhileTheVehicleTips) {
    rsi_test::MeasurementStage stage = stage_of(horizon_vehicle());
    rsi::Measurement measured;
    rsi_inputs inputs = rsi_test::at_rest();
    inputs.bank_angle_rad = nan;
    inputs.speed_mps = 20.0F;
    inputs.roll_angle_rad = 0.1F;
    for (int k = 0; k < 300; ++k) {
        stage.update(inputs, measured);
    }
    ASSERT_NEAR(measured.roll_angle_rad, 0.0F, 0.002F);
    for (int k = 0; k < 100; ++k) {
        inputs.lateral_specific_force_mps2 = 12.0F;
        inputs.roll_rate_radps = 0.4F;
        inputs.roll_angle_rad += 0.006F;  // less than the gyro says
        ASSERT_TRUE(stage.update(inputs, measured));
    }
    EXPECT_EQ(measured.roll_source, RSI_ROLL_SENSOR);
    EXPECT_NEAR(measured.roll_angle_rad, 0.6F, 0.01F);
}

TEST(RoadBank, BeginsWithItsFirstSampleAndIsNoSteeperThan420Milliradians) {
    for (const float side : {1.0F, -1.0F}) {
        rsi::RoadBank bank;
        EXPECT_FALSE(bank.known());
        bank.follow(side * 0.11F, side * 0.01F);
        EXPECT_TRUE(bank.known());
        EXPECT_FLOAT_EQ(bank.angle_rad(), side * 0.1F);
        bank.reset();
        bank.follow(side * 0.43F, 0.0F);
        EXPECT_EQ(bank.angle_rad(), side * 0.42F);
    }
}

TEST(RoadBank, FollowsAnUprightBodyThroughALagOf50Milliseconds) {
    rsi::RoadBank bank;
    bank.follow(0.0F, 0.0F);
    bank.follow(0.1F, 0.0F);
    EXPECT_FLOAT_EQ(bank.angle_rad(), 0.02F);
}

TEST(RoadBank, FollowsTheSlowerTheMoreTheBodyRolls) {
    const auto after_a_second = [](float roll_rad) {
        rsi::RoadBank bank;
        bank.follow(roll_rad, roll_rad);
        for (int k = 0; k < 100; ++k) {
            bank.follow(roll_rad + 0.1F, roll_rad);
        }
        return static_cast<double>(bank.angle_rad()) / 0.1;
    };
    EXPECT_NEAR(after_a_second(0.0F), 1.0, 1.0e-3);
    EXPECT_NEAR(after_a_second(0.1F), 1.0 - std::exp(-1.0 / 0.55), 0.01);  // 0.05 s and 5 s/rad
    EXPECT_NEAR(after_a_second(-0.1F), after_a_second(0.1F), 1.0e-6);
}

}  // namespace
}  // namespace road_bank_test
