// From body-fixed sensors to the forces along and normal to the road, against the geometry of a rolled body
// on a banked road.
#include "rsi/measurement/measurement.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "tests/rsi/support/body_kinematics.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/stages.hpp"

namespace measurement_test {
namespace {

using rsi_test::GroundMotion;
using rsi_test::PlaneVector;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

// Float rounding of forces up to 20 m/s^2, through a handful of operations.
constexpr double force_tolerance = 1.0e-5;

rsi_test::MeasurementStage stage_of(const rsi_parameters& parameters) {
    rsi_test::MeasurementStage stage;
    stage.init(parameters);
    return stage;
}

rsi::Measurement measure(const rsi_inputs& inputs) {
    rsi_test::MeasurementStage stage = stage_of(rsi_test::large_suv());
    rsi::Measurement measurement;
    EXPECT_TRUE(stage.update(inputs, measurement));
    return measurement;
}

// A grid over turns of both directions, roll, bank; with or without vertical acceleration.
template <typename Check>
void for_each_motion(double vertical_acceleration_mps2, Check check) {
    for (const double a_y : {-9.0, -4.0, 0.0, 2.0, 8.0}) {
        for (const double roll : {-0.2, -0.05, 0.0, 0.1, 0.3}) {
            for (const double bank : {-0.3, 0.0, 0.08, 0.25}) {
                check(GroundMotion{a_y, vertical_acceleration_mps2, bank, roll});
            }
        }
    }
}

TEST(Measurement, WithVerticalForceTheRoadForcesNeedNoBankAngle) {
    for_each_motion(0.7, [](const GroundMotion& motion) {
        const PlaneVector expected = rsi_test::specific_force_along(motion, motion.bank_angle_rad);
        rsi_inputs inputs = rsi_test::sensed(motion);
        inputs.bank_angle_rad = nan;
        const rsi::Measurement measured = measure(inputs);
        EXPECT_NEAR(static_cast<double>(measured.road_parallel_force_mps2), expected.left, force_tolerance);
        EXPECT_NEAR(static_cast<double>(measured.road_normal_force_mps2), expected.up, force_tolerance);
        EXPECT_EQ(measured.lateral_acceleration_mps2, measured.road_parallel_force_mps2);
        EXPECT_EQ(measured.tan_bank_angle, 0.0F);
    });
}

TEST(Measurement, WithVerticalForceAndBankTheLateralAccelerationIsTheHorizontalOne) {
    for_each_motion(0.7, [](const GroundMotion& motion) {
        const rsi::Measurement measured = measure(rsi_test::sensed(motion));
        EXPECT_NEAR(static_cast<double>(measured.lateral_acceleration_mps2), motion.lateral_acceleration_mps2,
                    force_tolerance);
    });
}

TEST(Measurement, WithoutVerticalForceTheForcesFollowFromTheBankWhileNothingHeaves) {
    for_each_motion(0.0, [](const GroundMotion& motion) {
        const PlaneVector expected = rsi_test::specific_force_along(motion, motion.bank_angle_rad);
        rsi_inputs inputs = rsi_test::sensed(motion);
        inputs.vertical_specific_force_mps2 = nan;
        const rsi::Measurement measured = measure(inputs);
        EXPECT_NEAR(static_cast<double>(measured.road_parallel_force_mps2), expected.left, force_tolerance);
        EXPECT_NEAR(static_cast<double>(measured.road_normal_force_mps2), expected.up, force_tolerance);
        EXPECT_NEAR(static_cast<double>(measured.lateral_acceleration_mps2), motion.lateral_acceleration_mps2,
                    force_tolerance);
    });
}

TEST(Measurement, WithNeitherVerticalForceNorBankTheRoadCountsAsFlat) {
    for (const double roll : {-0.2, 0.0, 0.15}) {
        const GroundMotion motion{5.0, 0.0, 0.0, roll};
        rsi_inputs inputs = rsi_test::sensed(motion);
        inputs.vertical_specific_force_mps2 = nan;
        inputs.bank_angle_rad = nan;
        const rsi::Measurement measured = measure(inputs);
        EXPECT_NEAR(static_cast<double>(measured.road_parallel_force_mps2), 5.0, force_tolerance);
        EXPECT_NEAR(static_cast<double>(measured.road_normal_force_mps2), rsi_test::gravity_mps2,
                    force_tolerance);
    }
}

TEST(Measurement, AStandingVehicleOnABankFeelsGravityAlongTheRoad) {
    const rsi::Measurement measured = measure(rsi_test::sensed(GroundMotion{0.0, 0.0, 0.1, 0.02}));
    EXPECT_GT(measured.road_parallel_force_mps2, 0.9F);
    EXPECT_NEAR(static_cast<double>(measured.lateral_acceleration_mps2), 0.0, force_tolerance);
}

TEST(Measurement, TheNormalForceNeverFallsBelowATenthOfGravity) {
    rsi_inputs inputs = rsi_test::at_rest();
    for (const float vertical : {0.5F, 0.0F, -30.0F}) {
        inputs.vertical_specific_force_mps2 = vertical;
        EXPECT_FLOAT_EQ(measure(inputs).road_normal_force_mps2, 0.980665F);
    }
}

// A rigid body turning with constant angular acceleration about its forward and upward axes; the IMU sits
// away from the CG, which itself feels a constant force. Full vector algebra in double.
struct TurningBody {
    Eigen::Vector3d cg_force{0.0, 3.0, rsi_test::gravity_mps2};
    Eigen::Vector3d angular_acceleration{0.8, 0.0, -0.5};
    Eigen::Vector3d imu{1.2, -0.4, 0.3};

    Eigen::Vector3d angular_rate(double time_s) const {
        return Eigen::Vector3d{0.3, 0.0, -0.2} + angular_acceleration * time_s;
    }

    Eigen::Vector3d force_at_imu(double time_s) const {
        const Eigen::Vector3d omega = angular_rate(time_s);
        return cg_force + angular_acceleration.cross(imu) + omega.cross(omega.cross(imu));
    }
};

rsi_inputs inputs_of(const TurningBody& body, double time_s) {
    rsi_inputs inputs = rsi_test::at_rest();
    inputs.lateral_specific_force_mps2 = static_cast<float>(body.force_at_imu(time_s).y());
    inputs.roll_rate_radps = static_cast<float>(body.angular_rate(time_s).x());
    inputs.yaw_rate_radps = static_cast<float>(body.angular_rate(time_s).z());
    return inputs;
}

rsi_parameters with_imu_of(const TurningBody& body, float lag_s) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.imu_x_m = static_cast<float>(body.imu.x());
    parameters.imu_y_m = static_cast<float>(body.imu.y());
    parameters.imu_z_m = static_cast<float>(body.imu.z());
    parameters.angular_acceleration_lag_s = lag_s;
    return parameters;
}

TEST(Measurement, TheForceIsCarriedFromTheImuToTheCentreOfGravity) {
    const TurningBody body;
    for (const float lag_s : {0.0F, 0.02F, 0.1F}) {
        rsi_test::MeasurementStage stage = stage_of(with_imu_of(body, lag_s));
        rsi::Measurement measured;
        for (int k = 0; k <= 200; ++k) {  // 2 s: the slowest lag has settled to exp(-20)
            ASSERT_TRUE(stage.update(inputs_of(body, 0.01 * k), measured));
        }
        // One float rounding of a rate of 2 rad/s over 10 ms is 1.2e-5 rad/s^2, with arms of 1.2 and 0.3 m.
        EXPECT_NEAR(static_cast<double>(measured.road_parallel_force_mps2), body.cg_force.y(), 1.0e-4)
            << "lag " << lag_s;
    }
}

TEST(Measurement, TheFirstSampleUsesNoAngularAcceleration) {
    const TurningBody body;
    rsi_test::MeasurementStage stage = stage_of(with_imu_of(body, 0.0F));
    rsi::Measurement measured;
    ASSERT_TRUE(stage.update(inputs_of(body, 0.0), measured));
    const double missing = body.angular_acceleration.cross(body.imu).y();
    EXPECT_NEAR(static_cast<double>(measured.road_parallel_force_mps2), body.cg_force.y() + missing, 1.0e-5);
}

TEST(Measurement, AGapForgetsTheRatesBeforeIt) {
    const TurningBody body;
    rsi_test::MeasurementStage stage = stage_of(with_imu_of(body, 0.0F));
    rsi::Measurement measured;
    rsi_inputs before = inputs_of(body, 0.0);
    before.roll_rate_radps = -8.0F;
    ASSERT_TRUE(stage.update(before, measured));
    rsi_inputs gap = before;
    gap.lateral_specific_force_mps2 = nan;
    ASSERT_FALSE(stage.update(gap, measured));
    ASSERT_TRUE(stage.update(inputs_of(body, 1.0), measured));
    const double missing = body.angular_acceleration.cross(body.imu).y();
    EXPECT_NEAR(static_cast<double>(measured.road_parallel_force_mps2), body.cg_force.y() + missing, 1.0e-5);
}

TEST(Measurement, WithoutYawRateTheRollPartOfTheLeverArmRemains) {
    TurningBody body;
    body.angular_acceleration.z() = 0.0;
    rsi_test::MeasurementStage stage = stage_of(with_imu_of(body, 0.0F));
    rsi::Measurement measured;
    for (int k = 0; k <= 10; ++k) {
        rsi_inputs inputs = inputs_of(body, 0.01 * k);
        inputs.yaw_rate_radps = nan;
        ASSERT_TRUE(stage.update(inputs, measured));
    }
    const double yaw_rate = body.angular_rate(0.1).z();
    const double missing = -yaw_rate * yaw_rate * body.imu.y();
    EXPECT_NEAR(static_cast<double>(measured.road_parallel_force_mps2), body.cg_force.y() + missing, 1.0e-4);
}

struct InputLimit {
    const char* name;
    float rsi_inputs::* field;
    float limit;
    bool necessary;
};

constexpr InputLimit input_limits[] = {
    {"lateral_specific_force_mps2", &rsi_inputs::lateral_specific_force_mps2, 60.0F, true},
    {"vertical_specific_force_mps2", &rsi_inputs::vertical_specific_force_mps2, 60.0F, false},
    {"roll_rate_radps", &rsi_inputs::roll_rate_radps, 10.0F, true},
    {"roll_angle_rad", &rsi_inputs::roll_angle_rad, 2.2F, true},
    {"yaw_rate_radps", &rsi_inputs::yaw_rate_radps, 10.0F, false},
    {"bank_angle_rad", &rsi_inputs::bank_angle_rad, 0.8F, false},
};

TEST(Measurement, AnInputAtItsLimitIsAvailableAndBeyondItIsNot) {
    for (const InputLimit& input : input_limits) {
        rsi_inputs inputs = rsi_test::at_rest();
        rsi_test::MeasurementStage stage = stage_of(rsi_test::large_suv());
        rsi::Measurement measured;
        for (const float sign : {-1.0F, 1.0F}) {
            inputs.*input.field = sign * input.limit;
            EXPECT_TRUE(stage.update(inputs, measured)) << input.name;
            for (const float bad : {sign * input.limit * 1.0001F, sign * infinity, nan}) {
                inputs.*input.field = bad;
                EXPECT_EQ(stage.update(inputs, measured), !input.necessary) << input.name << " = " << bad;
            }
        }
    }
}

TEST(Measurement, AnOptionalInputOutOfRangeIsTheSameAsAMissingOne) {
    for (const InputLimit& input : input_limits) {
        if (input.necessary) {
            continue;
        }
        rsi_inputs inputs = rsi_test::sensed(GroundMotion{4.0, 0.3, 0.1, 0.05});
        inputs.yaw_rate_radps = 0.4F;
        inputs.*input.field = nan;
        const rsi::Measurement missing = measure(inputs);
        for (const float bad : {infinity, -infinity, 1.001F * input.limit}) {
            inputs.*input.field = bad;
            const rsi::Measurement measured = measure(inputs);
            EXPECT_EQ(measured.road_parallel_force_mps2, missing.road_parallel_force_mps2) << input.name;
            EXPECT_EQ(measured.road_normal_force_mps2, missing.road_normal_force_mps2) << input.name;
            EXPECT_EQ(measured.lateral_acceleration_mps2, missing.lateral_acceleration_mps2) << input.name;
        }
    }
}

TEST(Measurement, TheSpeedIsNotNeeded) {
    rsi_inputs inputs = rsi_test::at_rest();
    inputs.speed_mps = nan;
    EXPECT_FLOAT_EQ(measure(inputs).road_normal_force_mps2, 9.80665F);
}

// The observer stands in for the roll sensor only while it has yaw rate and speed; one of them is not enough,
// and after a gap of a single sample it has to find the angle anew.
TEST(Measurement, WithoutRollSensorNeedsYawRateAndSpeedBoth) {
    rsi_inputs driving{};
    driving.vertical_specific_force_mps2 = 9.80665F;
    driving.bank_angle_rad = nan;
    driving.speed_mps = 25.0F;
    driving.roll_angle_rad = 0.0F;
    rsi_inputs without_sensor = driving;
    without_sensor.roll_angle_rad = nan;
    const auto known_after_gap_of = [&](float yaw_rate_radps, float speed_mps) {
        rsi_test::MeasurementStage stage = stage_of(rsi_test::large_suv());
        rsi::Measurement measurement;
        for (int k = 0; k < 300; ++k) {
            EXPECT_TRUE(stage.update(driving, measurement));
        }
        EXPECT_TRUE(stage.update(without_sensor, measurement));
        EXPECT_EQ(measurement.roll_source, RSI_ROLL_OBSERVER);
        rsi_inputs gap = without_sensor;
        gap.yaw_rate_radps = yaw_rate_radps;
        gap.speed_mps = speed_mps;
        return stage.update(gap, measurement);
    };
    EXPECT_TRUE(known_after_gap_of(0.0F, 25.0F));
    for (const float bad : {nan, infinity, 1.0e3F}) {
        EXPECT_FALSE(known_after_gap_of(bad, 25.0F)) << bad;
        EXPECT_FALSE(known_after_gap_of(0.0F, bad)) << bad;
    }
}

// Upright, so that the forces along and normal to the road are those of the body.
TEST(Measurement, TheVerticalForceIsCarriedToo) {
    const TurningBody body;
    rsi_test::MeasurementStage stage = stage_of(with_imu_of(body, 0.0F));
    rsi::Measurement measured;
    for (int k = 0; k <= 10; ++k) {
        rsi_inputs inputs = inputs_of(body, 0.01 * k);
        inputs.vertical_specific_force_mps2 = static_cast<float>(body.force_at_imu(0.01 * k).z());
        ASSERT_TRUE(stage.update(inputs, measured));
    }
    EXPECT_NEAR(static_cast<double>(measured.road_normal_force_mps2), body.cg_force.z(), 1.0e-4);
}

// f_y = A cos phi + N sin phi has no solution where the body lies across; a tenth is divided by instead.
TEST(Measurement, WithoutVerticalForceABodyAcrossTheHorizonDividesByATenth) {
    rsi_inputs inputs = rsi_test::at_rest();
    inputs.vertical_specific_force_mps2 = nan;
    inputs.lateral_specific_force_mps2 = 7.0F;
    inputs.roll_angle_rad = 1.2F;
    inputs.bank_angle_rad = 0.5F;
    const double normal = rsi_test::gravity_mps2 / std::cos(0.5);
    const double parallel = (7.0 - normal * std::sin(1.2)) / 0.1;
    EXPECT_NEAR(static_cast<double>(measure(inputs).road_parallel_force_mps2), parallel, 1.0e-3);
}

TEST(Measurement, TheRatesBeforeAGapOfTheRollAngleAreForgotten) {
    const TurningBody body;
    rsi_test::MeasurementStage stage = stage_of(with_imu_of(body, 0.0F));
    rsi::Measurement measured;
    rsi_inputs before = inputs_of(body, 0.0);
    before.roll_rate_radps = -8.0F;
    before.yaw_rate_radps = 3.0F;
    ASSERT_TRUE(stage.update(before, measured));
    rsi_inputs gap = before;
    gap.roll_angle_rad = nan;
    gap.speed_mps = nan;
    ASSERT_FALSE(stage.update(gap, measured));
    ASSERT_TRUE(stage.update(inputs_of(body, 1.0), measured));
    const double missing = body.angular_acceleration.cross(body.imu).y();
    EXPECT_NEAR(static_cast<double>(measured.road_parallel_force_mps2), body.cg_force.y() + missing, 1.0e-5);
}

// Whether the roll sensor is seen to disagree in 4 s of a turn, left or right, in which it shows a share of
// what the observer finds, and `offset_rad` more.
bool disagrees_in_a_turn(rsi_test::MeasurementStage& stage, float side, float share,
                         float offset_rad = 0.0F) {
    rsi::Measurement measured;
    rsi_inputs inputs = rsi_test::at_rest();
    inputs.speed_mps = 20.0F;
    inputs.lateral_specific_force_mps2 = side * 6.0F;
    inputs.yaw_rate_radps = side * 0.3F;
    for (int k = 0; k < 400; ++k) {
        EXPECT_TRUE(stage.update(inputs, measured));
        const float observed_rad = measured.observed.roll_angle_rad;  // not known at first
        inputs.roll_angle_rad = std::isfinite(observed_rad) ? share * observed_rad + offset_rad : 0.0F;
    }
    EXPECT_GT(side * measured.observed.roll_angle_rad, 0.06F);
    return measured.observed.sensor_disagrees;
}

// Beyond both what the observer finds and what a body under that load would do.
TEST(Measurement, ALoadExcusesARollAngleUpToItsShare) {
    for (const float side : {1.0F, -1.0F}) {
        const auto disagrees = [side](float roll_factor, float sensed_over_observed) {
            rsi_test::MeasurementStage stage = stage_of(rsi_test::large_suv());
            stage.learnt.roll_factor = roll_factor;
            return disagrees_in_a_turn(stage, side, sensed_over_observed);
        };
        EXPECT_FALSE(disagrees(1.0F, 1.0F));
        EXPECT_TRUE(disagrees(1.0F, 2.0F));
        EXPECT_FALSE(disagrees(2.0F, 2.0F));
        EXPECT_FALSE(disagrees(2.0F, 1.0F));
        EXPECT_TRUE(disagrees(2.0F, 3.0F));
        EXPECT_TRUE(disagrees(2.0F, 0.0F));
        EXPECT_TRUE(disagrees(0.6F, 2.0F));
        EXPECT_FALSE(disagrees(0.6F, 0.6F));
    }
}

// 0.05 rad are the calibrated limit.
TEST(Measurement, WithoutALoadNothingIsExcused) {
    const auto disagrees = [](float offset_rad) {
        rsi_test::MeasurementStage stage = stage_of(rsi_test::large_suv());
        return disagrees_in_a_turn(stage, 1.0F, 1.0F, offset_rad);
    };
    EXPECT_TRUE(disagrees(0.052F));
    EXPECT_FALSE(disagrees(0.048F));
    EXPECT_TRUE(disagrees(-0.052F));
    EXPECT_FALSE(disagrees(-0.048F));
}

// The roll sensor of a tipping vehicle is not compared with a model that ends there: what was found before
// stays.
TEST(Measurement, TheRollSensorIsNotJudgedWhileTheVehicleTips) {
    for (const bool tips : {false, true}) {
        rsi_test::MeasurementStage stage = stage_of(rsi_test::large_suv());
        rsi::Measurement measured;
        rsi_inputs inputs = rsi_test::at_rest();
        inputs.speed_mps = 20.0F;
        for (int k = 0; k < 100; ++k) {
            ASSERT_TRUE(stage.update(inputs, measured));
        }
        ASSERT_FALSE(measured.observed.sensor_disagrees);
        inputs.lateral_specific_force_mps2 = tips ? 8.5F : 0.0F;  // it tips at 7.94
        inputs.yaw_rate_radps = tips ? 0.4F : 0.0F;
        inputs.roll_angle_rad = 0.3F;
        for (int k = 0; k < 60; ++k) {
            ASSERT_TRUE(stage.update(inputs, measured));
        }
        EXPECT_EQ(measured.observed.sensor_disagrees, !tips);
    }
}

TEST(Measurement, TheObserverTakesASpeedUpToItsLimitAndNoneBeyond) {
    for (const float sign : {1.0F, -1.0F}) {
        rsi_test::MeasurementStage stage = stage_of(rsi_test::large_suv());
        rsi::Measurement measured;
        rsi_inputs inputs = rsi_test::at_rest();
        inputs.roll_angle_rad = nan;
        inputs.speed_mps = sign * 150.0F;
        bool known = false;
        for (int k = 0; k < 100; ++k) {
            known = stage.update(inputs, measured);
        }
        EXPECT_TRUE(known);
        inputs.speed_mps = sign * 150.1F;
        EXPECT_FALSE(stage.update(inputs, measured));
    }
}

}  // namespace
}  // namespace measurement_test
