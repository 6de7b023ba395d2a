// The states that faults are injected in are what their names say.
#include "sil/studies/faults/driving_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sil/studies/faults/good_sensors.hpp"
#include "sil/studies/faults/turned_housings.hpp"
#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/support/large_suv.h"

namespace faults_test {
namespace {

using sil::DrivingState;
using sil::SensorSample;

const sil::VehicleParameters& large_suv() {
    static const sil::VehicleParameters vehicle =
        sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/large_suv.toml");
    return vehicle;
}

const std::vector<DrivingState>& states() {
    static const std::vector<DrivingState> all =
        sil::record_states(large_suv(), {sil::recording_sensors(large_suv())}).front();
    return all;
}

double largest(const DrivingState& state, double SensorSample::* value, std::size_t begin, std::size_t end) {
    double found = 0.0;
    for (std::size_t cycle = begin; cycle < end; ++cycle) {
        found = std::max(found, std::abs(state.samples[cycle].*value));
    }
    return found;
}

double largest(const DrivingState& state, double SensorSample::* value) {
    return largest(state, value, 0U, state.samples.size());
}

TEST(DrivingState, StandsAndCrawls) {
    EXPECT_LT(largest(states()[0], &SensorSample::speed_mps), 0.2);
    const DrivingState& slow = states()[1];
    EXPECT_LT(largest(slow, &SensorSample::speed_mps), 18.0 / 3.6);
    EXPECT_GT(largest(slow, &SensorSample::yaw_rate_radps), 0.1);
    EXPECT_EQ(slow.fault_begin, 400U);
    EXPECT_EQ(slow.fault_end, slow.samples.size());
    EXPECT_FALSE(slow.two_wheel_lift);
}

TEST(DrivingState, HasTheFaultFromThePowerOnOfAnEcuThatIsToWarn) {
    const DrivingState& state = states()[2];
    EXPECT_EQ(state.fault_begin, 0U);
    EXPECT_LT(largest(state, &SensorSample::lateral_acceleration_mps2, 0U, 450U), 1.0);
    ASSERT_TRUE(state.two_wheel_lift);
    EXPECT_GT(*state.two_wheel_lift, 500U);
}

TEST(DrivingState, StartsTheEcuInATurn) {
    const DrivingState& state = states()[3];
    EXPECT_EQ(state.fault_begin, 0U);
    EXPECT_GT(std::abs(state.samples[0].lateral_acceleration_mps2), 1.0);
    EXPECT_TRUE(state.two_wheel_lift);
    EXPECT_EQ(state.samples.size() - *state.two_wheel_lift,
              states()[4].samples.size() - *states()[4].two_wheel_lift);
}

TEST(DrivingState, DrivesAMinuteOfTurnsOfAFifthOfGToBothSides) {
    const DrivingState& state = states()[4];
    EXPECT_GE(state.ordinary_end - state.fault_begin, 6000U);
    int left = 0;
    int right = 0;
    double sum_mps2 = 0.0;
    for (std::size_t cycle = state.fault_begin; cycle < state.ordinary_end; ++cycle) {
        left += state.samples[cycle].yaw_rate_radps > 0.05 ? 1 : 0;
        right += state.samples[cycle].yaw_rate_radps < -0.05 ? 1 : 0;
        EXPECT_NEAR(state.samples[cycle].speed_mps, 80.0 / 3.6, 2.0);
        const double force_mps2 =
            std::abs(state.samples[cycle].yaw_rate_radps * state.samples[cycle].speed_mps);
        sum_mps2 += force_mps2 > 1.1 ? force_mps2 : 0.0;
    }
    EXPECT_NEAR(sum_mps2 / (left + right), 2.0, 0.3);
    EXPECT_GT(left, 1000);
    EXPECT_GT(right, 1000);
    ASSERT_TRUE(state.two_wheel_lift);
    EXPECT_GT(*state.two_wheel_lift, state.ordinary_end);
    EXPECT_FALSE(state.with_frame_faults);
}

// The same drive for all of them, and each differs from the usual ones.
TEST(GoodSensors, SeeTheSameDriveInAnotherWay) {
    std::vector<sil::SensorOptions> options{sil::recording_sensors(large_suv())};
    const std::vector<sil::GoodSensors> good =
        sil::good_sensors(sil::recording_sensors(large_suv()), rsi_test_large_suv());
    for (const sil::GoodSensors& each : good) {
        options.push_back(each.options);
    }
    const auto drives = sil::record_drives_of_good_sensors(large_suv(), options);
    ASSERT_EQ(drives.size(), good.size() + 1U);
    const DrivingState& usual = drives[0].front();
    for (std::size_t index = 0U; index < good.size(); ++index) {
        SCOPED_TRACE(good[index].name);
        const DrivingState& other = drives[index + 1U].front();
        ASSERT_EQ(other.samples.size(), usual.samples.size());
        EXPECT_EQ(other.two_wheel_lift, usual.two_wheel_lift);
        bool differs = false;
        for (std::size_t cycle = 0U; cycle < usual.samples.size(); ++cycle) {
            const SensorSample& a = usual.samples[cycle];
            const SensorSample& b = other.samples[cycle];
            differs = differs || a.lateral_acceleration_mps2 != b.lateral_acceleration_mps2 ||
                      a.roll_angle_rad != b.roll_angle_rad || a.roll_rate_radps != b.roll_rate_radps ||
                      a.speed_mps != b.speed_mps || a.steering_wheel_angle_rad != b.steering_wheel_angle_rad;
        }
        EXPECT_TRUE(differs);
    }
}

// Long enough for a memory of minutes; the J-turn is the same.
TEST(DrivingState, DrivesTenMinutesOrNoneBeforeTheSameTurn) {
    const std::vector<DrivingState> both =
        sil::record_ten_minutes(large_suv(), {sil::recording_sensors(large_suv())}).front();
    ASSERT_EQ(both.size(), 2U);
    for (const DrivingState& state : both) {
        EXPECT_EQ(state.fault_begin, 0U);
        EXPECT_EQ(state.fault_end, state.samples.size());
        ASSERT_TRUE(state.two_wheel_lift);
    }
    EXPECT_NEAR(static_cast<double>(*both[1].two_wheel_lift - *both[0].two_wheel_lift), 60000.0, 30.0);
    EXPECT_GT(largest(both[1], &SensorSample::lateral_acceleration_mps2, 0U, 60000U), 2.0);
    EXPECT_LT(largest(both[1], &SensorSample::lateral_acceleration_mps2, 0U, 60000U), 4.5);
}

// One of either sign, each of them the accelerometer's alone.
TEST(ALastingOffset, IsATurnedHousingOrABias) {
    const sil::SensorOptions usual = sil::recording_sensors(large_suv());
    double sum = 0.0;
    const std::vector<sil::TurnedHousing> all = sil::lasting_offsets(usual);
    ASSERT_EQ(all.size(), 10U);
    for (const sil::TurnedHousing& each : all) {
        const bool turned = each.fault.kind == sil::FaultKind::turned_about_x;
        EXPECT_EQ(each.options.imu.tilt.roll_rad, turned ? each.fault.magnitude : 0.0);
        EXPECT_EQ(each.options.imu.lateral_acceleration_mps2.bias,
                  turned ? usual.imu.lateral_acceleration_mps2.bias : each.fault.magnitude);
        sum += each.fault.magnitude;
    }
    EXPECT_NEAR(sum, 0.0, 1.0e-12);
}

// Gravity stands on the lateral axis; the rest, the noise among it, is as of the usual sensors.
TEST(ATurnedHousing, TurnsBothAccelerationsTogether) {
    const sil::SensorOptions usual = sil::recording_sensors(large_suv());
    const std::vector<sil::TurnedHousing> turned = sil::turned_housings(usual);
    ASSERT_EQ(turned.size(), 12U);
    std::vector<sil::SensorOptions> options{usual};
    for (const sil::TurnedHousing& each : turned) {
        options.push_back(each.options);
    }
    const std::vector<sil::RecordedDrive> drives = sil::record_rest(large_suv(), 0.1, options);
    for (std::size_t index = 0U; index < turned.size(); ++index) {
        const sil::SensorSample& right = drives[0U].samples.back();
        const sil::SensorSample& sample = drives[index + 1U].samples.back();
        const double about_x =
            turned[index].fault.kind == sil::FaultKind::turned_about_x ? turned[index].fault.magnitude : 0.0;
        EXPECT_NEAR(sample.lateral_acceleration_mps2 - right.lateral_acceleration_mps2,
                    9.80665 * std::sin(about_x), 0.001);
        EXPECT_NEAR(sample.vertical_acceleration_mps2 - right.vertical_acceleration_mps2,
                    9.80665 * (std::cos(about_x) - 1.0), 0.001);
        EXPECT_EQ(sample.roll_angle_rad, right.roll_angle_rad);
    }
}

}  // namespace
}  // namespace faults_test
