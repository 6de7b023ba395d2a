// Lift-off: from wheel loads, or as given.
#include "sil/studies/drives/lift_off.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace {

using Loads = std::array<double, 4>;

// 3 s at 100 Hz; 16 kN on four wheels, so 1 % of a wheel's static load is 40 N.
sil::Drive driving() {
    sil::Drive drive;
    for (int index = 0; index <= 300; ++index) {
        sil::DriveSample sample;
        sample.time_s = 0.01 * index;
        sample.wheel_load_n = Loads{5000.0, 5000.0, 3000.0, 3000.0};
        drive.samples.push_back(sample);
    }
    return drive;
}

void load_from(sil::Drive& drive, std::size_t first, const Loads& loads_n) {
    for (std::size_t index = first; index < drive.samples.size(); ++index) {
        drive.samples[index].wheel_load_n = loads_n;
    }
}

TEST(LiftOff, IsUnknownWithoutWheelLoads) {
    sil::Drive drive = driving();
    const double nan = sil::DriveSample::not_available;
    load_from(drive, 0U, {nan, nan, nan, nan});
    const sil::LiftOff lift = sil::find_lift_off(drive);
    EXPECT_EQ(lift.source, sil::LiftOffSource::unknown);
    EXPECT_FALSE(lift.one_wheel_s || lift.two_wheel_s);
    EXPECT_TRUE(std::isnan(sil::load_transfer_ratio(drive.samples[0])));
}

TEST(LiftOff, DoesNotHappenWhileEveryWheelCarriesOnePercent) {
    sil::Drive drive = driving();
    load_from(drive, 150U, {41.0, 7959.0, 41.0, 7959.0});
    const sil::LiftOff lift = sil::find_lift_off(drive);
    EXPECT_EQ(lift.source, sil::LiftOffSource::wheel_loads);
    EXPECT_FALSE(lift.one_wheel_s || lift.two_wheel_s);
}

TEST(LiftOff, OfOneWheelThenOfBothWheelsOfASide) {
    sil::Drive drive = driving();
    load_from(drive, 150U, {100.0, 7900.0, 39.0, 7961.0});
    load_from(drive, 180U, {39.0, 7961.0, 0.0, 8000.0});
    const sil::LiftOff lift = sil::find_lift_off(drive);
    EXPECT_DOUBLE_EQ(lift.one_wheel_s.value(), 1.5);
    EXPECT_DOUBLE_EQ(lift.two_wheel_s.value(), 1.8);
}

TEST(LiftOff, OfTheRightSideCountsAsWell) {
    sil::Drive drive = driving();
    load_from(drive, 200U, {8000.0, 0.0, 8000.0, 0.0});
    EXPECT_DOUBLE_EQ(sil::find_lift_off(drive).two_wheel_s.value(), 2.0);
}

TEST(LiftOff, TellsTheSideThatFalls) {
    sil::Drive drive = driving();
    load_from(drive, 200U, {8000.0, 0.0, 8000.0, 0.0});
    EXPECT_EQ(sil::find_lift_off(drive).falling_side, sil::WarningSide::left);
    load_from(drive, 200U, {0.0, 8000.0, 0.0, 8000.0});
    EXPECT_EQ(sil::find_lift_off(drive).falling_side, sil::WarningSide::right);
}

TEST(LiftOff, OfTwoWheelsHasToLastFiftyMilliseconds) {
    sil::Drive drive = driving();
    load_from(drive, 200U, {8000.0, 0.0, 8000.0, 0.0});  // from 2.00 to 2.04 s
    load_from(drive, 205U, {5000.0, 5000.0, 3000.0, 3000.0});
    EXPECT_FALSE(sil::find_lift_off(drive).two_wheel_s);
    EXPECT_DOUBLE_EQ(sil::find_lift_off(drive).one_wheel_s.value(), 2.0);
    drive.samples[205U].wheel_load_n = Loads{8000.0, 0.0, 8000.0, 0.0};
    EXPECT_DOUBLE_EQ(sil::find_lift_off(drive).two_wheel_s.value(), 2.0);
}

TEST(LiftOff, OfTwoWheelsOnOppositeSidesIsNotTwoWheelLiftOff) {
    sil::Drive drive = driving();
    load_from(drive, 200U, {0.0, 8000.0, 8000.0, 0.0});
    const sil::LiftOff lift = sil::find_lift_off(drive);
    EXPECT_DOUBLE_EQ(lift.one_wheel_s.value(), 2.0);
    EXPECT_FALSE(lift.two_wheel_s);
}

TEST(LiftOff, GivenTimesWinOverWheelLoads) {
    sil::Drive drive = driving();
    load_from(drive, 200U, {8000.0, 0.0, 8000.0, 0.0});
    drive.lift_off_given = true;
    drive.one_wheel_lift_s = 1.25;
    const sil::LiftOff lift = sil::find_lift_off(drive);
    EXPECT_EQ(lift.source, sil::LiftOffSource::given);
    EXPECT_DOUBLE_EQ(lift.one_wheel_s.value(), 1.25);
    EXPECT_FALSE(lift.two_wheel_s);
    EXPECT_EQ(lift.falling_side, sil::WarningSide::none);
}

TEST(LiftOff, OfAGivenTimeTheLoadsTellTheSide) {
    sil::Drive drive = driving();
    drive.lift_off_given = true;
    drive.two_wheel_lift_s = 2.0;
    EXPECT_EQ(sil::find_lift_off(drive).falling_side, sil::WarningSide::none);
    load_from(drive, 150U, {7000.0, 1000.0, 8000.0, 0.0});
    load_from(drive, 190U, {0.0, 0.0, 0.0, 0.0});  // in the air
    load_from(drive, 201U, {1000.0, 7000.0, 0.0, 8000.0});
    EXPECT_EQ(sil::find_lift_off(drive).falling_side, sil::WarningSide::left);
    drive.two_wheel_lift_s = 2.01;
    EXPECT_EQ(sil::find_lift_off(drive).falling_side, sil::WarningSide::right);
}

TEST(LoadTransferRatio, IsPositiveWhenTheRightWheelsCarryMore) {
    sil::DriveSample sample;
    sample.wheel_load_n = Loads{1000.0, 3000.0, 1000.0, 3000.0};
    EXPECT_DOUBLE_EQ(sil::load_transfer_ratio(sample), 0.5);
    sample.wheel_load_n = Loads{4000.0, 0.0, 4000.0, 0.0};
    EXPECT_DOUBLE_EQ(sil::load_transfer_ratio(sample), -1.0);
    sample.wheel_load_n = Loads{0.0, 0.0, 0.0, 0.0};
    EXPECT_TRUE(std::isnan(sil::load_transfer_ratio(sample)));
}

}  // namespace
