// Settings: the built-in ones, files, and what is refused.
#include "sil/studies/campaign/settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sil/campaign/small_campaign.hpp"
#include "tests/support/scratch_folder.hpp"

namespace settings_test {
namespace {

using testing::HasSubstr;

sil::CampaignSettings load(const std::string& text) {
    const test_support::ScratchFolder folder;
    test_support::write_text(folder.path() / "mine.toml", text);
    return sil::load_campaign(folder.path() / "mine.toml");
}

void expect_refused(const std::string& text, const std::string& why) {
    try {
        load(text);
        FAIL() << "was accepted: " << text;
    } catch (const sil::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(why));
    }
}

TEST(CampaignSettings, TheBuiltInOnesAreThoseOfTheFile) {
    EXPECT_EQ(sil::to_toml(sil::default_campaign()),
              sil::to_toml(
                  sil::load_campaign(testing_campaign::project_file("sil/studies/campaign/default.toml"))));
}

TEST(CampaignSettings, TheBuiltInSpreadIsWhatWasAskedFor) {
    const sil::CampaignSpread spread = sil::default_campaign().spread;
    EXPECT_EQ(spread.cg_height_error, 0.05);
    EXPECT_EQ(spread.stiffness_error, 0.10);
    EXPECT_EQ(spread.mass_error, 0.05);
    EXPECT_EQ(spread.accelerometer_bias_g, 0.005);
    EXPECT_TRUE(spread.sensor_noise);
    EXPECT_TRUE(spread.steering_sensor);
    EXPECT_TRUE(spread.roll_sensor);
    EXPECT_GE(sil::default_campaign().vehicles.size(), 2U);
}

TEST(CampaignSettings, TheirTextIsReadBackAsTheSame) {
    sil::CampaignSettings settings = testing_campaign::small_campaign(17U);
    settings.vehicles[0].parameters = "a \"strange\" \\ path";
    settings.spread.mass_error = 1.0 / 3.0;
    EXPECT_EQ(sil::to_toml(load(sil::to_toml(settings))), sil::to_toml(settings));
}

TEST(CampaignSettings, OptionalSettingsAreReadBackAsTheSame) {
    sil::CampaignSettings settings = testing_campaign::small_campaign(17U);
    const std::string without = sil::to_toml(settings);
    for (const char* key : {"class", "speed_factors", "steering_factors", "load_is_known", "attitude_sensor",
                            "changes", "learning_s", "mass_sensor", "housing_tilt_deg", "lever_arm_error_m",
                            "mass_signal_factor", "intervention", "handwheel_rate_degps"}) {
        EXPECT_EQ(without.find(key), std::string::npos) << "said only where it says something: " << key;
    }
    settings.vehicles[1].in_class = "light truck";
    settings.vehicles[1].mass_sensor = true;
    settings.vehicles[1].speed_factors = {0.5, 1.0};
    settings.vehicles[1].steering_factors = {2.0, 1.0 / 3.0};
    settings.spread.load_is_known = false;
    settings.spread.attitude_sensor = true;
    settings.spread.load_share = {};
    settings.spread.housing_tilt_deg = 2.0;
    settings.spread.lever_arm_error_m = 0.1;
    settings.spread.mass_signal_factor = {0.85, 1.3};
    settings.manoeuvres[0].handwheel_rate_degps = {200.0, 1200.0};
    settings.learning_s = 120.0;
    settings.changes = {"warning_on=0.9", "warning_hold_s=1"};
    settings.intervention = {"published", 0.75, {sil::InterventionKind::brake, 0.1, 0.2, 4.0, 0.0}};
    const sil::CampaignSettings read = load(sil::to_toml(settings));
    EXPECT_EQ(read.vehicles[0].in_class, "");
    EXPECT_EQ(read.vehicles[1].in_class, "light truck");
    EXPECT_FALSE(read.vehicles[0].mass_sensor);
    EXPECT_TRUE(read.vehicles[1].mass_sensor);
    EXPECT_EQ(read.vehicles[1].speed_factors, settings.vehicles[1].speed_factors);
    EXPECT_EQ(read.vehicles[1].steering_factors, settings.vehicles[1].steering_factors);
    EXPECT_FALSE(read.spread.load_is_known);
    EXPECT_TRUE(read.spread.attitude_sensor);
    EXPECT_EQ(read.spread.housing_tilt_deg, 2.0);
    EXPECT_EQ(read.spread.lever_arm_error_m, 0.1);
    EXPECT_EQ(read.spread.mass_signal_factor.highest, 1.3);
    EXPECT_EQ(read.manoeuvres[0].handwheel_rate_degps.highest, 1200.0);
    EXPECT_FALSE(read.manoeuvres[1].has_handwheel_rate());
    EXPECT_EQ(read.changes, settings.changes);
    EXPECT_EQ(read.learning_s, settings.learning_s);
    ASSERT_TRUE(read.intervention.has_value());
    EXPECT_EQ(read.intervention->index, "published");
    EXPECT_EQ(read.intervention->level, 0.75);
    EXPECT_EQ(read.intervention->action.deceleration_mps2, 4.0);
    EXPECT_EQ(sil::to_toml(read), sil::to_toml(settings));
    settings.intervention->action = {sil::InterventionKind::driver, 1.0, 0.3, 0.0, 0.5};
    const sil::CampaignSettings driver = load(sil::to_toml(settings));
    EXPECT_EQ(driver.intervention->action.kind, sil::InterventionKind::driver);
    EXPECT_EQ(driver.intervention->action.steer_back_share, 0.5);
    EXPECT_EQ(sil::to_toml(driver), sil::to_toml(settings));
    settings.intervention->index = sil::CampaignIntervention::firmware;
    EXPECT_EQ(sil::to_toml(settings).find("level"), std::string::npos) << "its levels are the calibration's";
    EXPECT_EQ(sil::to_toml(load(sil::to_toml(settings))), sil::to_toml(settings));
}

TEST(CampaignSettings, AnInterventionThatIsNotWholeOrOutOfRangeIsRefused) {
    const auto table = [](const std::string& index, const std::string& level, const std::string& rest) {
        return "[intervention]\nindex = \"" + index + "\"\nlevel = " + level + "\n" + rest;
    };
    const std::string times = "delay_s = 0.1\nramp_s = 0.2\n";
    const std::string brake = times + "kind = \"brake\"\ndeceleration_mps2 = 4.0\n";
    load(table("published", "1.0", brake));
    expect_refused(table("hunch", "1.0", brake),
                   "\"intervention.index\" must be one of warning, published, ");
    expect_refused(table("warning", "1.0", brake), "\"intervention.level\" is not known");
    expect_refused(table("published", "0.0", brake), "\"intervention.level\" must be from 0.001 to 100");
    expect_refused(table("published", "101.0", brake), "\"intervention.level\" must be from 0.001 to 100");
    expect_refused("[intervention]\nlevel = 1.0\n" + brake, "\"intervention.index\" is missing");
    expect_refused(table("published", "1.0", times), "\"intervention.kind\" is missing");
    expect_refused(table("published", "1.0", "kind = \"brake\"\nramp_s = 0.2\n"),
                   "\"intervention.delay_s\" is missing");
    expect_refused(table("published", "1.0", times + "kind = \"horn\"\n"),
                   "mine.toml:6: \"intervention.kind\"");
    expect_refused(table("published", "1.0", times + "kind = \"brake\"\n"),
                   "\"intervention.deceleration_mps2\" is missing");
    expect_refused(table("published", "1.0", brake + "steer_back_share = 0.5\n"),
                   "mine.toml:8: \"intervention.steer_back_share\" is not known");
    expect_refused(table("published", "1.0", times + "kind = \"brake\"\ndeceleration_mps2 = 0.0\n"),
                   "\"intervention.deceleration_mps2\" must be from 0.1 to 12");
    expect_refused(table("published", "1.0", times + "kind = \"driver\"\nsteer_back_share = 1.5\n"),
                   "\"intervention.steer_back_share\" must be a share from 0 to 1");
    expect_refused(
        table("published", "1.0", "delay_s = -0.1\nramp_s = 0.2\nkind = \"driver\"\nsteer_back_share = 1\n"),
        "\"intervention.delay_s\" must be seconds from 0 to 5");
    expect_refused(
        table("published", "1.0", "delay_s = 0.1\nramp_s = 6.0\nkind = \"driver\"\nsteer_back_share = 1\n"),
        "\"intervention.ramp_s\" must be seconds from 0 to 5");
}

TEST(CampaignSettings, ValuesThatAFileLeavesOutAreBuiltIn) {
    const sil::CampaignSettings settings = load("seed = 9\n[spread]\nmass_error = 0.02\n");
    EXPECT_EQ(settings.seed, 9U);
    EXPECT_EQ(settings.spread.mass_error, 0.02);
    EXPECT_EQ(settings.spread.stiffness_error, 0.10);
    EXPECT_EQ(settings.manoeuvres.size(), sil::default_campaign().manoeuvres.size());
}

TEST(CampaignSettings, APathThatBeginsWithADotStartsFromTheFileAndAnyOtherFromTheCurrentFolder) {
    const test_support::ScratchFolder folder;
    test_support::write_text(folder.path() / "mine.toml",
                             "[[vehicle]]\nparameters = \"./a/b.toml\"\ncalibration = \"../c.toml\"\n"
                             "[[vehicle]]\nparameters = \"a/b.toml\"\ncalibration = \"/d/c.toml\"\n"
                             "[[vehicle]]\nparameters = \".a/b.toml\"\ncalibration = \"..c.toml\"\n");
    const std::vector<sil::CampaignVehicle> vehicles =
        sil::load_campaign(folder.path() / "mine.toml").vehicles;
    EXPECT_EQ(vehicles[0].parameters, (folder.path() / "a/b.toml").string());
    EXPECT_EQ(vehicles[0].calibration, (folder.path().parent_path() / "c.toml").string());
    EXPECT_EQ(vehicles[1].parameters, "a/b.toml");
    EXPECT_EQ(vehicles[1].calibration, "/d/c.toml");
    EXPECT_EQ(vehicles[2].parameters, ".a/b.toml");
    EXPECT_EQ(vehicles[2].calibration, "..c.toml");
}

TEST(CampaignSettings, ErrorsAreNamedWithLineAndKey) {
    expect_refused("runs = 5\nsede = 1\n", "mine.toml:2: \"sede\" is not known");
    expect_refused("runs = 5\n\"a\\u0000b\" = 1\n", "mine.toml:2: \"a?b\" is not known here; remove it");
    expect_refused("runs = 1.5\n", "mine.toml:1: \"runs\" must be a whole number");
    expect_refused("runs = -1\n", "\"runs\" must be a whole number");
    expect_refused("runs = 0\n", "\"runs\" must be from 1");
    const std::string no_load = "[spread]\nload_share = [0.0, 0.0]\n";
    expect_refused("learning_s = -1.0\n" + no_load, "\"learning_s\" must be seconds from 0 to 600");
    expect_refused("learning_s = 600.1\n" + no_load, "\"learning_s\" must be seconds from 0 to 600");
    expect_refused("learning_s = 1.0\n[spread]\nload_share = [0.0, 0.1]\n", "\"load_share\" must be [0, 0]");
    expect_refused("[spread]\nhousing_tilt_deg = -1.0\n", "\"housing_tilt_deg\" must be from 0 to 20");
    expect_refused("[spread]\nlever_arm_error_m = 1.5\n", "\"lever_arm_error_m\" must be from 0 to 1");
    expect_refused("[spread]\nmass_signal_factor = [0.4, 1.0]\n",
                   "\"mass_signal_factor\" must be two numbers from 0.5 to 2");
    expect_refused("[spread]\nmass_error = nan\n",
                   "mine.toml:2: \"spread.mass_error\" is not a finite number");
    expect_refused("[spread]\nmass_error = 0.9\n", "\"mass_error\" must be a share from 0 to 0.5");
    expect_refused("[spread]\nfriction_factor = 1.0\n",
                   "\"spread.friction_factor\" must be numbers in brackets");
    expect_refused("[spread]\nfriction_factor = [1.0]\n", "\"spread.friction_factor\" must be two numbers");
    expect_refused("[spread]\nfriction_factor = [1.2, 0.8]\n", "the lower one first");
    expect_refused("[spread]\nsensor_noise = 1\n", "must be true or false");
    expect_refused("[[vehicle]]\nparameters = \"a\"\n",
                   "mine.toml:1: \"vehicle.calibration\" is missing; add a text");
    expect_refused("[vehicle]\nparameters = \"a\"\n", "must be written as [[vehicle]]");
    expect_refused("[[manoeuvre]]\nname = \"pirouette\"\n", "There is no manoeuvre 'pirouette'");
    expect_refused("[[manoeuvre]]\nname = \"straight\"\nweight = 0\n", "weight");
    expect_refused("changes = \"warning_on=0.9\"\n", "\"changes\" must be texts in brackets");
    expect_refused("changes = [\"warning_on=0.9\", 1]\n", "\"changes\" must be texts in brackets");
    const std::string vehicle = "[[vehicle]]\nparameters = \"a\"\ncalibration = \"b\"\n";
    expect_refused(vehicle + "speed_factors = [1.0]\n", "vehicle a: speed_factors");
    expect_refused(vehicle + "steering_factors = [1.0]\n", "vehicle a: steering_factors");
    const std::string turn = "[[manoeuvre]]\nname = \"j-turn-45\"\n";
    expect_refused(vehicle + "speed_factors = [0.04]\n" + turn, "one number from 0.05 to 20");
    expect_refused(vehicle + "speed_factors = [20.1]\n" + turn, "one number from 0.05 to 20");
    expect_refused(vehicle + "class = \"a,b\"\n", "vehicle a: class");
    expect_refused(turn + "handwheel_rate_degps = [300, 0]\n",
                   "handwheel_rate_degps\" must be two numbers from 10");
    expect_refused("[[manoeuvre]]\nname = \"slalom\"\nhandwheel_rate_degps = [300, 400]\n",
                   "must be left out: its steering has no ramp of one rate");
    expect_refused("runs = \n", "mine.toml:1: not valid TOML");
}

TEST(CampaignSettings, AFileThatIsNotThereIsNamed) {
    try {
        sil::load_campaign("/nowhere/mine.toml");
        FAIL() << "was accepted";
    } catch (const sil::InputError& error) {
        EXPECT_STREQ(error.what(),
                     "/nowhere/mine.toml: cannot be read: No such file or directory; check the path and the "
                     "permissions");
    }
}

TEST(CampaignSettings, AVehicleOnTheCommandLineIsTwoPaths) {
    const sil::CampaignVehicle vehicle = sil::parse_campaign_vehicle("a/b.toml:c.toml");
    EXPECT_EQ(vehicle.parameters, "a/b.toml");
    EXPECT_EQ(vehicle.calibration, "c.toml");
    for (const char* wrong : {"a.toml", ":c.toml", "a.toml:", ""}) {
        EXPECT_THROW(sil::parse_campaign_vehicle(wrong), sil::InputError) << wrong;
    }
}

}  // namespace
}  // namespace settings_test
