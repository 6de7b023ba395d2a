// Sensors that a vehicle does not have: nothing of them is missed, nor read if it is sent all the same.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/application/bench.hpp"

namespace testing_application {
namespace {

using State = rsi::can_dbc::RolloverWarning::State;
using Code = rsi::can_dbc::RolloverDiagnosis::Code;
using Degradation = rsi::can_dbc::RolloverDiagnosis::Degradation;

rsi::Parameters without_roll_sensor() {
    rsi::Parameters suv = large_suv();
    suv.roll_angle_sensor = RSI_ROLL_SENSOR_NOT_FITTED;
    return suv;
}

rsi::Parameters with_motion(rsi_vehicle_motion_sensors sensors) {
    rsi::Parameters suv = large_suv();
    suv.vehicle_motion_sensors = sensors;
    return suv;
}

void expect_no_complaint(const Bench& bench) {
    for (const Cycle& cycle : bench.cycles()) {
        ASSERT_EQ(cycle.diagnosis.value.code, Code::none);
        const rsi::can_dbc::RolloverStatus& status = cycle.status.value;
        ASSERT_FALSE(status.roll_angle_timeout || status.roll_angle_signal_invalid ||
                     status.vehicle_motion_timeout || status.vehicle_motion_signal_invalid);
    }
    EXPECT_EQ(bench.state(), State::ready);
}

rsi::can_dbc::RolloverDiagnosis::Degradation degradation(const Bench& bench) {
    return bench.last().diagnosis.value.degradation;
}

TEST(SensorsFitted, AreMissedWhereTheCalibrationSaysThatTheyAreThere) {
    Bench bench;
    bench.stop(Sensor::roll_angle);
    bench.stop(Sensor::vehicle_motion);
    bench.run_for(3.0);
    EXPECT_TRUE(bench.status().roll_angle_timeout);
    EXPECT_TRUE(bench.status().vehicle_motion_timeout);
    EXPECT_NE(bench.last().diagnosis.value.code, Code::none);
}

TEST(SensorsFitted, LeaveTheRollAngleToTheObserverWithoutARollSensor) {
    Bench bench{without_roll_sensor()};
    bench.stop(Sensor::roll_angle);
    bench.run_for(3.0);
    expect_no_complaint(bench);
    EXPECT_EQ(degradation(bench), Degradation::roll_sensor_lost);
}

TEST(SensorsFitted, ReadNoFramesOfASensorThatIsNotThere) {
    Bench bench{without_roll_sensor()};
    Motion motion;
    motion.roll_angle = {80.0F, 40.0F};  // nonsense
    bench.drive(motion);
    bench.tamper(Sensor::roll_angle, [](rsi::hal::CanFrame& frame) { frame.data[0] ^= 1U; });
    bench.run_for(3.0);
    expect_no_complaint(bench);
    EXPECT_TRUE(std::isnan(bench.inputs().roll_angle_rad));
    EXPECT_TRUE(std::isnan(bench.inputs().bank_angle_rad));
    EXPECT_EQ(bench.status().frames_rejected, 0U);
}

TEST(SensorsFitted, GoOnWithoutTheVehiclesMotion) {
    for (const bool sent : {false, true}) {
        Bench bench{with_motion(RSI_MOTION_NOT_FITTED)};
        if (!sent) {
            bench.stop(Sensor::vehicle_motion);
        }
        bench.run_for(3.0);
        expect_no_complaint(bench);
        EXPECT_EQ(degradation(bench), Degradation::motion_lost);
        EXPECT_TRUE(std::isnan(bench.inputs().speed_mps));
        EXPECT_TRUE(std::isnan(bench.inputs().yaw_rate_radps));
        EXPECT_TRUE(std::isnan(bench.inputs().steering_wheel_angle_rad));
    }
}

TEST(SensorsFitted, GoOnWithoutSteering) {
    for (const float sent_deg : {rsi::can_dbc::not_available, 20.0F}) {
        Bench bench{with_motion(RSI_MOTION_WITHOUT_STEERING)};
        Motion motion;
        motion.vehicle_motion.steering_wheel_angle_deg = sent_deg;
        bench.drive(motion);
        bench.run_for(3.0);
        expect_no_complaint(bench);
        EXPECT_EQ(degradation(bench), Degradation::full);
        EXPECT_TRUE(std::isnan(bench.inputs().steering_wheel_angle_rad));
        EXPECT_NEAR(bench.inputs().speed_mps, 80.0F / 3.6F, 0.01F);
    }
}

TEST(SensorsFitted, StillMissSpeedAndYawRateWithoutSteering) {
    for (float rsi::can_dbc::VehicleMotion::* const missing :
         {&rsi::can_dbc::VehicleMotion::speed_kmh, &rsi::can_dbc::VehicleMotion::yaw_rate_deg_per_s}) {
        Bench bench{with_motion(RSI_MOTION_WITHOUT_STEERING)};
        Motion motion;
        motion.vehicle_motion.*missing = rsi::can_dbc::not_available;
        bench.drive(motion);
        bench.run_for(1.0);
        EXPECT_TRUE(bench.status().vehicle_motion_signal_invalid);
        EXPECT_NE(bench.last().diagnosis.value.code, Code::none);
    }
}

TEST(SensorsFitted, GoOnWithoutAVerticalAccelerationThatWasNeverThere) {
    Bench bench;
    Motion motion;
    motion.imu.vertical_acceleration_mps2 = rsi::can_dbc::not_available;
    bench.drive(motion);
    bench.stop(Sensor::imu);
    bench.run_cycles(3);  // nothing is known yet
    bench.resume(Sensor::imu);
    bench.run_for(3.0);
    expect_no_complaint(bench);
    EXPECT_FALSE(bench.status().imu_signal_invalid);
    EXPECT_EQ(degradation(bench), Degradation::full);
    EXPECT_TRUE(std::isnan(bench.inputs().vertical_specific_force_mps2));
}

TEST(SensorsFitted, MissAVerticalAccelerationThatWasThere) {
    Bench bench;
    bench.run_for(1.0);
    Motion motion;
    motion.imu.vertical_acceleration_mps2 = rsi::can_dbc::not_available;
    bench.drive(motion);
    bench.run_for(1.0);
    EXPECT_TRUE(bench.status().imu_signal_invalid);
    EXPECT_EQ(bench.last().diagnosis.value.code, Code::vertical_acceleration_invalid);
}

TEST(SensorsFitted, MissTheOtherSignalsOfAnImuWithoutVerticalAcceleration) {
    for (float rsi::can_dbc::Imu::* const missing :
         {&rsi::can_dbc::Imu::lateral_acceleration_mps2, &rsi::can_dbc::Imu::roll_rate_deg_per_s}) {
        Bench bench;
        Motion motion;
        motion.imu.vertical_acceleration_mps2 = rsi::can_dbc::not_available;
        motion.imu.*missing = rsi::can_dbc::not_available;
        bench.drive(motion);
        bench.run_for(1.0);
        EXPECT_TRUE(bench.status().imu_signal_invalid);
        EXPECT_EQ(bench.state(), State::unavailable);
    }
}

TEST(SensorsFitted, MissASteeringAngleThatIsSaidToBeThere) {
    Bench bench;
    Motion motion;
    motion.vehicle_motion.steering_wheel_angle_deg = rsi::can_dbc::not_available;
    bench.drive(motion);
    bench.run_for(1.0);
    EXPECT_TRUE(bench.status().vehicle_motion_signal_invalid);
    EXPECT_EQ(bench.last().diagnosis.value.code, Code::steering_invalid);
}

}  // namespace
}  // namespace testing_application
