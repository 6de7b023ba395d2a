// Vehicle data: what is missing or wrong is named with file, line and what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "sil/studies/identification/vehicle_data.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

constexpr const char* good =
    "name = \"test\"\ntotal_mass_kg = 2000.0\nsprung_mass_kg = 1750.0\ncg_height_m = 0.7\nwheel_radius_m = "
    "0.35\n"
    "track_width_m = 1.6\nwheelbase_m = 2.8\nimu_z_m = -0.2\n";

sil::VehicleData loaded(const std::string& text, const std::vector<std::string>& settings = {}) {
    const test_support::ScratchFolder folder;
    const std::string path = folder.path() / "vehicle_data.toml";
    test_support::write_text(path, text);
    return sil::load_vehicle_data(path, settings);
}

std::string refusal(const std::string& text, const std::vector<std::string>& settings = {}) {
    try {
        loaded(text, settings);
    } catch (const sil::InputError& error) {
        return error.what();
    }
    return "accepted";
}

// m h_total = m_s h + m_u h_u: 2000 x 0.7 = 1750 h + 250 x 0.35
TEST(VehicleDataTest, SprungCgHeightFollowsFromTheWholeVehicles) {
    const sil::VehicleData data = loaded(good);
    EXPECT_NEAR(data.sprung_cg_height_m, (1400.0 - 87.5) / 1750.0, 1e-9);
    EXPECT_NEAR(data.unsprung_mass_kg, 250.0, 1e-9);
    EXPECT_TRUE(data.assumptions.empty());
}

TEST(VehicleDataTest, ASettingReplacesTheFilesValue) {
    const sil::VehicleData data = loaded(good, {"track_width_m=1.5", "steering_ratio=18"});
    EXPECT_DOUBLE_EQ(data.track_width_m, 1.5);
    EXPECT_DOUBLE_EQ(data.steering_ratio.value(), 18.0);
}

TEST(VehicleDataTest, SettingsAloneAreEnough) {
    const sil::VehicleData data = sil::load_vehicle_data(
        {}, {"total_mass_kg=2000", "cg_height_m=0.7", "track_width_m=1.6", "wheelbase_m=2.8"});
    EXPECT_NEAR(data.unsprung_mass_kg, 260.0, 1e-9);
    EXPECT_THAT(data.assumptions, Contains(HasSubstr("unsprung mass taken as 13 %")));
    EXPECT_THAT(data.assumptions, Contains(HasSubstr("imu_z_m is not given")));
}

TEST(VehicleDataTest, MaySayWhatTheRollAngleIsMeasuredAgainst) {
    EXPECT_FALSE(loaded(good).roll_angle_reference.has_value());
    EXPECT_EQ(loaded(good, {"roll_angle_reference=road"}).roll_angle_reference, sil::RollReference::road);
    EXPECT_EQ(loaded(good, {"roll_angle_reference=horizon"}).roll_angle_reference,
              sil::RollReference::horizon);
    EXPECT_THAT(refusal(good, {"roll_angle_reference=gravity"}), HasSubstr("\"road\", \"horizon\""));
}

TEST(VehicleDataTest, TrackWidthIsTheMeanOfBothAxles) {
    std::string text = good;
    text.replace(text.find("track_width_m = 1.6"), 19,
                 "track_width_front_m = 1.62\ntrack_width_rear_m = 1.58");
    EXPECT_NEAR(loaded(text).track_width_m, 1.6, 1e-9);
}

TEST(VehicleDataTest, AMissingKeyIsNamed) {
    EXPECT_THAT(refusal("total_mass_kg = 2000.0\n"), AllOf(HasSubstr("is missing"), HasSubstr("--set")));
}

TEST(VehicleDataTest, AMassInTonnesIsRefusedWithLineAndRange) {
    EXPECT_THAT(refusal("total_mass_kg = 2.0\n"),
                AllOf(HasSubstr(":1: \"total_mass_kg\" is 2"), HasSubstr("from 150")));
}

TEST(VehicleDataTest, AHeightInMillimetresIsRefused) {
    EXPECT_THAT(refusal(good, {"cg_height_m=700"}), HasSubstr("cg_height_m"));
}

TEST(VehicleDataTest, MassesThatDoNotAddUpAreRefused) {
    EXPECT_THAT(refusal(good, {"unsprung_mass_kg=500"}), HasSubstr("Correct one of the three"));
    EXPECT_THAT(refusal(good, {"sprung_mass_kg=2100"}), HasSubstr("Correct the masses"));
}

TEST(VehicleDataTest, AnUnknownKeyIsRefusedWithItsLine) {
    EXPECT_THAT(refusal(std::string{good} + "track = 1.6\n"),
                AllOf(HasSubstr(":9: \"track\""), HasSubstr("is not known")));
}

TEST(VehicleDataTest, TextInPlaceOfANumberIsRefused) {
    EXPECT_THAT(refusal("total_mass_kg = \"2 t\"\n"), HasSubstr("must be a number"));
    EXPECT_THAT(refusal(good, {"track_width_m=wide"}), HasSubstr("must be a number"));
    EXPECT_THAT(refusal(good, {"track_width_m"}), HasSubstr("KEY=VALUE"));
}

TEST(VehicleDataTest, AFileThatIsNotThereIsNamed) {
    try {
        sil::load_vehicle_data("no/such/file.toml");
        FAIL();
    } catch (const sil::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("no/such/file.toml: cannot be read"));
    }
}

}  // namespace
