// Good drives: units, missing optional columns, and what editors and other systems do to a file.
#include "sil/studies/drives/drive_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/sil/drives/drive_text.hpp"

namespace {

using testing_drives::good_lines;
using testing_drives::text_of_lines;

sil::Drive drive_of(const std::string& header, const std::string& values, const std::string& remarks = "") {
    return sil::parse_drive_csv(remarks + header + "\n" + "0," + values + "\n" + "0.01," + values + "\n",
                                "some/where/name.csv");
}

TEST(DriveCsv, ReadsEveryQuantityInSiUnits) {
    const sil::Drive drive = drive_of(
        "time_s,speed_kmh,lateral_acceleration_g,vertical_acceleration_g,roll_rate_degps,yaw_rate_radps,"
        "roll_angle_rad,steering_wheel_angle_deg,bank_angle_deg,wheel_load_front_left_kn,"
        "wheel_load_front_right_n,wheel_load_rear_left_n,wheel_load_rear_right_n",
        "72,0.5,1,90,-0.25,0.125,180,-45,4.5,3000,2000,1000");
    ASSERT_EQ(drive.samples.size(), 2U);
    const sil::DriveSample& sample = drive.samples[1];
    EXPECT_DOUBLE_EQ(sample.time_s, 0.01);
    EXPECT_DOUBLE_EQ(sample.speed_mps, 20.0);
    EXPECT_DOUBLE_EQ(sample.lateral_acceleration_mps2, 4.903325);
    EXPECT_DOUBLE_EQ(sample.vertical_acceleration_mps2, 9.80665);
    EXPECT_NEAR(sample.roll_rate_radps, 1.5707963267948966, 1e-15);
    EXPECT_DOUBLE_EQ(sample.yaw_rate_radps, -0.25);
    EXPECT_DOUBLE_EQ(sample.roll_angle_rad, 0.125);
    EXPECT_NEAR(sample.steering_wheel_angle_rad, 3.141592653589793, 1e-15);
    EXPECT_NEAR(sample.bank_angle_rad, -0.7853981633974483, 1e-15);
    EXPECT_THAT(sample.wheel_load_n, testing::ElementsAre(4500.0, 3000.0, 2000.0, 1000.0));
    EXPECT_EQ(drive.name, "name");
    EXPECT_FALSE(drive.lift_off_given);
}

TEST(DriveCsv, ReadsTheOtherUnitsToo) {
    const sil::Drive drive = sil::parse_drive_csv(
        "TIME_MS,speed_mph,lateral_acceleration_mps2,roll_rate_radps,yaw_rate_degps\n0,10,1,2,180\n10,10,1,2,"
        "180\n",
        "name.csv");
    EXPECT_DOUBLE_EQ(drive.samples[1].time_s, 0.01);
    EXPECT_DOUBLE_EQ(drive.samples[1].speed_mps, 4.4704);
    EXPECT_DOUBLE_EQ(drive.samples[1].roll_rate_radps, 2.0);
    EXPECT_NEAR(drive.samples[1].yaw_rate_radps, 3.141592653589793, 1e-15);
}

TEST(DriveCsv, MissingValuesAreNotAvailable) {
    const sil::Drive drive =
        drive_of("time_s,lateral_acceleration_mps2,roll_rate_degps,roll_angle_deg,bank_angle_deg", "1,2,3,");
    const sil::DriveSample& sample = drive.samples[0];
    EXPECT_DOUBLE_EQ(sample.lateral_acceleration_mps2, 1.0);
    EXPECT_TRUE(std::isnan(sample.bank_angle_rad));  // an empty field
    EXPECT_TRUE(std::isnan(sample.speed_mps));       // no column
    EXPECT_TRUE(std::isnan(sample.vertical_acceleration_mps2));
    EXPECT_TRUE(std::isnan(sample.wheel_load_n[0]));
}

TEST(DriveCsv, UnknownColumnsAreNamedAndIgnored) {
    const sil::Drive drive = drive_of(
        "time_s,gear,lateral_acceleration_mps2,roll_rate_degps,roll_angle_deg,roll_angle_to_horizon_deg,"
        "timer",
        "D,1,2,3,x,y");
    EXPECT_THAT(drive.ignored_columns, testing::ElementsAre("gear", "roll_angle_to_horizon_deg", "timer"));
}

TEST(DriveCsv, LineEndsMarksBlanksAndQuotesOfOtherSystemsAreAccepted) {
    const std::string plain = text_of_lines(good_lines());
    std::string foreign = "\xEF\xBB\xBF";
    for (const char character : plain) {
        foreign += character == '\n' ? "\r\n" : character == ',' ? " , " : std::string(1U, character);
    }
    foreign.replace(foreign.find("roll_rate_degps"), 15U, "\"Roll_Rate_DegPS\"");
    foreign += "\r\n\r\n";
    const sil::Drive expected = sil::parse_drive_csv(plain, "a.csv");
    const sil::Drive actual = sil::parse_drive_csv(foreign, "a.csv");
    ASSERT_EQ(actual.samples.size(), expected.samples.size());
    for (std::size_t index = 0U; index < actual.samples.size(); ++index) {
        EXPECT_EQ(actual.samples[index].time_s, expected.samples[index].time_s);
        EXPECT_EQ(actual.samples[index].roll_rate_radps, expected.samples[index].roll_rate_radps);
        EXPECT_EQ(actual.samples[index].yaw_rate_radps, expected.samples[index].yaw_rate_radps);
    }
}

TEST(DriveCsv, LiftOffIsGivenInRemarks) {
    const std::string columns = "time_s,lateral_acceleration_mps2,roll_rate_degps,roll_angle_deg";
    const sil::Drive rolled = drive_of(columns, "1,2,3",
                                       "# made by hand: twice\n# one_wheel_lift_time_ms: 5\n"
                                       "#two_wheel_lift_time_s:0.0075\n");
    EXPECT_TRUE(rolled.lift_off_given);
    EXPECT_DOUBLE_EQ(rolled.one_wheel_lift_s.value(), 0.005);
    EXPECT_DOUBLE_EQ(rolled.two_wheel_lift_s.value(), 0.0075);
    const sil::Drive upright = drive_of(columns, "1,2,3", "# two_wheel_lift_time_s: none\n");
    EXPECT_TRUE(upright.lift_off_given);
    EXPECT_FALSE(upright.two_wheel_lift_s.has_value());
}

TEST(DriveCsv, TimesOfTheCalendarKeepTheirMilliseconds) {
    const sil::Drive drive = sil::parse_drive_csv(
        "time_ms,lateral_acceleration_mps2,roll_rate_degps,roll_angle_deg\n"
        "1700000000000,1,2,3\n1700000000010,1,2,3\n",
        "a.csv");
    EXPECT_NEAR(drive.samples[1].time_s - drive.samples[0].time_s, 0.01, 1e-6);
}

}  // namespace
