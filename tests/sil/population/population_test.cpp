// Population: a folder of calibrated vehicles that does not depend on threads and interruptions, and drives.
#include "sil/studies/population/population.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "sil/files/calibration_file.hpp"
#include "sil/input_error.hpp"
#include "sil/studies/campaign/campaign_run.hpp"
#include "sil/studies/identification/simulated_drive.hpp"
#include "sil/studies/population/calibrated_vehicle.hpp"
#include "sil/studies/population/population_campaigns.hpp"
#include "sil/studies/population/vehicle_writer.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace population_test {
namespace {

using testing::HasSubstr;

const std::atomic<bool> never{false};

sil::PopulationRequest request_of(const std::filesystem::path& folder, std::uint64_t vehicles,
                                  unsigned jobs) {
    sil::PopulationRequest request;
    request.vehicles = vehicles;
    request.seed = 11U;
    request.output = folder;
    request.jobs = jobs;
    return request;
}

// Every file by its path below the folder.
std::map<std::string, std::string> content_of(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files[std::filesystem::relative(entry.path(), folder).string()] =
                test_support::text_of(entry.path());
        }
    }
    return files;
}

void expect_refused(const sil::PopulationRequest& request, const std::string& why) {
    try {
        sil::make_population(request, never);
        FAIL() << "was accepted";
    } catch (const sil::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(why));
    }
}

// Three vehicles, made once for the tests that only look at them.
class Population : public testing::Test {
 protected:
    static const std::filesystem::path& folder() {
        static const test_support::ScratchFolder scratch;
        static const bool made = [] {
            sil::make_population(request_of(scratch.path(), 3U, 2U), never);
            return true;
        }();
        EXPECT_TRUE(made);
        return scratch.path();
    }
};

TEST_F(Population, HasEveryFileOfEveryVehicle) {
    for (std::uint64_t number = 0U; number < 3U; ++number) {
        const sil::DrawnVehicle drawn = sil::draw_vehicle(11U, number);
        EXPECT_EQ(sil::vehicle_toml(sil::load_vehicle(sil::vehicle_file(folder(), drawn, false)), ""),
                  sil::vehicle_toml(drawn.parameters, ""));
        EXPECT_GT(sil::total_mass_kg(sil::load_vehicle(sil::vehicle_file(folder(), drawn, true))),
                  sil::total_mass_kg(drawn.parameters) + 100.0);
        for (const sil::CalibrationKind kind :
             {sil::CalibrationKind::with_loads, sil::CalibrationKind::without_loads,
              sil::CalibrationKind::of_loaded_vehicle}) {
            EXPECT_NO_THROW(sil::load_calibration(sil::calibration_file(folder(), drawn, kind).string()))
                << drawn.name;
        }
    }
    const std::string rows = test_support::text_of(folder() / "vehicles.csv");
    EXPECT_THAT(rows, HasSubstr("number,vehicle,class,half,"));
    EXPECT_THAT(rows, HasSubstr("\n2,suv-0002,SUV,choose,"));
    EXPECT_THAT(sil::describe_population(folder()), HasSubstr("SUV                   1           1"));
}

TEST_F(Population, OneThreadAnInterruptionAndAGrowthChangeNoByte) {
    const test_support::ScratchFolder scratch;
    std::atomic<bool> stop{false};
    const sil::RowProgress first = sil::make_population(request_of(scratch.path(), 2U, 1U), stop,
                                                        [&stop](const sil::RowProgress&) { stop = true; });
    EXPECT_EQ(first.finished, 1U);
    EXPECT_FALSE(std::filesystem::exists(scratch.path() / "settings_choose_clean.toml"));
    const sil::RowProgress rest = sil::make_population(request_of(scratch.path(), 3U, 1U), never);
    EXPECT_EQ(rest.begun_with, 1U);
    EXPECT_EQ(rest.finished, 3U);
    EXPECT_EQ(content_of(scratch.path()), content_of(folder()));
}

TEST_F(Population, TakesUpWhatIsItsOwnOnly) {
    const auto before = content_of(folder());
    EXPECT_EQ(sil::make_population(request_of(folder(), 3U, 1U), never).begun_with, 3U);
    EXPECT_EQ(content_of(folder()), before);
    sil::PopulationRequest other = request_of(folder(), 3U, 1U);
    other.seed = 12U;
    expect_refused(other, "is of another seed or another revision");
    expect_refused(request_of(folder(), 2U, 1U), "their number can grow, not shrink to 2");
    EXPECT_EQ(content_of(folder()), before);
}

TEST_F(Population, MayBeMoved) {
    const test_support::ScratchFolder scratch;
    const std::filesystem::path moved = scratch.path() / "moved";
    std::filesystem::copy(folder(), moved, std::filesystem::copy_options::recursive);
    const sil::CampaignSettings settings = sil::load_campaign(moved / "settings_choose_clean.toml");
    EXPECT_EQ(settings.vehicles[0].parameters, (moved / "vehicles/small-car-0000.toml").string());
    EXPECT_EQ(settings.vehicles[0].calibration, (moved / "calibrations/small-car-0000.toml").string());
    EXPECT_NO_THROW(sil::CampaignWorld{settings});
}

TEST_F(Population, ItsCampaignsRunWithTheClassInEveryRow) {
    EXPECT_FALSE(std::filesystem::exists(folder() / "settings_report_clean.toml"))
        << "none of three is in it";
    for (const sil::CampaignVariant variant : sil::campaign_variants()) {
        sil::CampaignSettings settings = sil::load_campaign(
            folder() / ("settings_choose_" + std::string{sil::variant_name(variant)} + ".toml"));
        ASSERT_EQ(settings.vehicles.size(), 3U);
        EXPECT_EQ(settings.runs, variant == sil::CampaignVariant::ordinary ? 9U : 300U);
        const bool errors = variant != sil::CampaignVariant::clean;
        EXPECT_EQ(settings.spread.sensor_noise, errors);
        EXPECT_EQ(settings.spread.cg_height_error, errors ? 0.05 : 0.0);
        EXPECT_EQ(settings.spread.stiffness_error, errors ? 0.10 : 0.0);
        const bool wrongly_loaded =
            variant == sil::CampaignVariant::loaded || variant == sil::CampaignVariant::unloaded;
        EXPECT_EQ(settings.spread.load_is_known, !wrongly_loaded);
        const bool wrong_mass = variant == sil::CampaignVariant::wrong_mass;
        EXPECT_EQ(settings.learning_s,
                  wrongly_loaded || wrong_mass || variant == sil::CampaignVariant::learnt ? 120.0 : 0.0);
        EXPECT_EQ(settings.spread.mass_signal_factor.highest, wrong_mass ? 1.3 : 1.0);
        EXPECT_EQ(settings.spread.housing_tilt_deg,
                  variant == sil::CampaignVariant::wrongly_mounted ? 2.0 : 0.0);
        EXPECT_EQ(settings.vehicles[0].parameters.find("vehicles_loaded") != std::string::npos,
                  variant == sil::CampaignVariant::loaded);
        EXPECT_EQ(settings.vehicles[0].calibration.find("calibrations_loaded") != std::string::npos,
                  variant == sil::CampaignVariant::unloaded);
        if (variant == sil::CampaignVariant::ordinary) {
            settings.manoeuvres[0].duration_s = 20.0;
        }
        settings.learning_s = std::min(settings.learning_s, 5.0);
        const sil::CampaignWorld world{settings};
        std::set<std::string> classes;
        for (std::uint64_t run = 0U; run < 6U; ++run) {
            const sil::CampaignRow row = world.run(run);
            classes.insert(row.in_class);
            EXPECT_GT(row.outcome.end_time_s, 0.5);
        }
        EXPECT_GE(classes.size(), 2U);
        EXPECT_EQ(classes.count(""), 0U);
    }
}

// Each class twice, laden too, through whatever the campaign has for it.
TEST(DrawnVehicles, AllDrive) {
    for (std::uint64_t number = 0U; number < 16U; ++number) {
        const sil::DrawnVehicle drawn = sil::draw_vehicle(1U, number);
        for (const sil::VehicleParameters& vehicle :
             {drawn.parameters, sil::loaded(drawn.parameters, sil::vehicle_classes()[drawn.in_class].load)}) {
            const sil::CampaignVehicle scaled = sil::scaled_vehicle(drawn, vehicle);
            for (const std::size_t index : {std::size_t{0U}, 3U + static_cast<std::size_t>(number % 8U),
                                            16U + static_cast<std::size_t>(number % 8U)}) {
                const sil::CampaignManoeuvre& manoeuvre = sil::population_manoeuvres()[index];
                sil::RunOptions options;
                options.speed_factor = scaled.speed_factors[index] * manoeuvre.speed_factor.highest;
                options.steering_factor = scaled.steering_factors[index] * manoeuvre.steering_factor.highest;
                options.duration_s = 6.0;
                sil::ManoeuvreRun run{vehicle, sil::find_manoeuvre(manoeuvre.name), options};
                while (!run.finished()) {
                    run.step();
                    ASSERT_TRUE(std::isfinite(run.truth().roll_angle_rad))
                        << drawn.name << " " << manoeuvre.name;
                }
                EXPECT_GT(std::abs(run.truth().position_x_m), 5.0) << drawn.name << " " << manoeuvre.name;
            }
        }
    }
}

TEST(PopulationCalibration, ARefusalOfIdentifyIsAReasonAndNoCalibration) {
    const test_support::ScratchFolder scratch;
    const sil::DrawnVehicle drawn = sil::draw_vehicle(1U, 3U);
    const std::filesystem::path data = scratch.path() / "data.toml";
    test_support::write_text(data, sil::vehicle_data_toml(drawn.parameters));
    sil::RunOptions brief;
    brief.duration_s = 4.0;
    sil::IdentificationDrives drives;
    drives.ramps.push_back(
        sil::simulate_drive(drawn.parameters, sil::find_manoeuvre("slow-ramp"), {}, brief));
    drives.dynamics = drives.ramps;
    for (sil::DriveSample& sample : drives.ramps.front().samples) {
        sample.roll_angle_rad = sil::DriveSample::not_available;
    }
    const sil::Calibrated calibrated = sil::calibrate(data, drives, scratch.path() / "calibration.toml");
    EXPECT_THAT(calibrated.failure, HasSubstr("has no roll angle"));
    EXPECT_FALSE(std::filesystem::exists(scratch.path() / "calibration.toml"));
    EXPECT_THAT(
        sil::calibrate(scratch.path() / "none.toml", drives, scratch.path() / "calibration.toml").failure,
        HasSubstr("none.toml"));
}

TEST(PopulationCalibration, WithoutLoadsTheDrivesAreTheSameButForThem) {
    sil::DriveSample sample;
    sample.roll_angle_rad = 0.125;
    sample.wheel_load_n = {1.0, 2.0, 3.0, 4.0};
    sil::Drive drive;
    drive.samples = {sample, sample};
    sil::IdentificationDrives drives;
    drives.ramps = {drive};
    drives.dynamics = {drive};
    const sil::IdentificationDrives without = drives.without_loads();
    EXPECT_EQ(drives.ramps[0].samples[1].wheel_load_n[3], 4.0);
    for (const sil::Drive* each : {&without.ramps[0], &without.dynamics[0]}) {
        EXPECT_EQ(each->samples[1].roll_angle_rad, 0.125);
        for (const double load : each->samples[1].wheel_load_n) {
            EXPECT_TRUE(std::isnan(load));
        }
    }
}

}  // namespace
}  // namespace population_test
