// Learning drive: calm, and what the component learns from it is what the vehicle carries.
#include "sil/studies/campaign/learning_drive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sil/files/calibration_file.hpp"
#include "sil/simulation/in_process_run.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/studies/campaign/campaign.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/load.hpp"
#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/sil/campaign/small_campaign.hpp"
#include "tests/support/scratch_folder.hpp"

namespace learning_drive_test {
namespace {

using testing_campaign::project_file;
using testing_campaign::small_campaign;

constexpr double a_minute_s = 60.0;

rsi::Parameters calibration() {
    return sil::load_calibration(project_file("firmware/calibrations/large_suv.toml"));
}

sil::VehicleParameters empty_vehicle() {
    return sil::load_vehicle(project_file("sil/vehicles/large_suv.toml"));
}

std::vector<rsi::Inputs> drive(const sil::VehicleParameters& vehicle, double duration_s = a_minute_s) {
    return sil::learning_drive(vehicle, sil::mounted_sensors(vehicle, {}), calibration(), duration_s);
}

float largest_force(const std::vector<rsi::Inputs>& inputs) {
    float largest = 0.0F;
    for (const rsi::Inputs& sample : inputs) {
        largest = std::max(largest, std::abs(sample.lateral_specific_force_mps2));
    }
    return largest;
}

TEST(LearningDrive, TakesItsTimeAndIsCalm) {
    const std::vector<rsi::Inputs> inputs = drive(empty_vehicle());
    EXPECT_EQ(inputs.size(), 6001U);
    EXPECT_GT(largest_force(inputs), 2.0F);
    EXPECT_LT(largest_force(inputs), 5.0F);
}

TEST(LearningDrive, IsCalmerInAVehicleThatTipsMoreEasily) {
    sil::VehicleParameters tall = empty_vehicle();
    tall.geometry.cg_height_m *= 1.6;
    ASSERT_LT(0.5 * sil::static_stability_factor(tall), 0.35);
    EXPECT_LT(largest_force(drive(tall)), largest_force(drive(empty_vehicle())));
}

TEST(LearningDrive, ShowsWhatTheVehicleCarries) {
    const sil::VehicleParameters empty = empty_vehicle();
    const double load_kg = 0.2 * empty.mass.sprung_kg;
    const double height_m = 1.5 * empty.geometry.cg_height_m;
    const rsi::LearntLoad without = sil::learnt_load(drive(empty, 2.0 * a_minute_s), calibration());
    const rsi::LearntLoad with =
        sil::learnt_load(drive(sil::with_load(empty, load_kg, height_m), 2.0 * a_minute_s), calibration());
    const rsi::Parameters p = calibration();
    const double arm_m = static_cast<double>(p.sprung_cg_height_m - p.fixed_roll_centre_height_m);
    const double expected = load_kg * (height_m - static_cast<double>(p.fixed_roll_centre_height_m)) /
                            (static_cast<double>(p.sprung_mass_kg) * arm_m);
    EXPECT_NEAR(static_cast<double>(with.excess - without.excess), expected, 0.15 * expected);
    EXPECT_LT(with.excess_deviation, 0.05F);
}

TEST(LearningDrive, TellsTheMassThatTheSensorTakesTheVehicleFor) {
    const sil::VehicleParameters vehicle = empty_vehicle();
    sil::SensorOptions sensors = sil::mounted_sensors(vehicle, {});
    sensors.mass.fitted = true;
    const std::vector<rsi::Inputs> inputs = sil::learning_drive(vehicle, sensors, calibration(), 10.0);
    for (const rsi::Inputs& sample : inputs) {
        // The signal has steps of 10 kg.
        ASSERT_NEAR(static_cast<double>(sample.vehicle_mass_kg), sil::total_mass_kg(vehicle), 5.0);
    }
    // A load that driving has not shown yet.
    EXPECT_GT(sil::learnt_load(inputs, calibration(), 0.1).excess,
              sil::learnt_load(inputs, calibration()).excess + 0.005F);
}

TEST(LearningDrive, IsWhatARunStartsWith) {
    const sil::VehicleParameters vehicle = empty_vehicle();
    const rsi::LearntLoad learnt{0.3F, 0.03F, 0.1F};
    sil::RunOptions one_cycle;
    one_cycle.duration_s = 0.01;
    sil::InProcessRun run{vehicle,       sil::find_manoeuvre("straight"),
                          one_cycle,     sil::mounted_sensors(vehicle, {}),
                          calibration(), nullptr,
                          learnt};
    run.run();
    EXPECT_NEAR(run.outputs().load_excess, 0.3F, 1.0e-3F);
    EXPECT_NEAR(run.outputs().load_excess_deviation, 0.03F, 1.0e-3F);
}

// The rows of a campaign of vehicles whose calibration takes them for much lighter above the roll centre.
std::string rows(double learning_s, unsigned jobs) {
    sil::CampaignSettings settings = small_campaign(6U);
    settings.learning_s = learning_s;
    settings.spread = {};
    settings.changes = {"load_adaptation=1", "sprung_mass_kg=1500"};
    const test_support::ScratchFolder folder;
    const std::atomic<bool> never{false};
    sil::run_campaign(sil::CampaignWorld{settings}, folder.path(), jobs, never);
    return test_support::text_of(folder.path() / "runs.csv");
}

TEST(LearningDrive, ChangesTheRunsOfACampaignWhateverTheThreads) {
    const std::string learnt = rows(30.0, 1U);
    EXPECT_NE(learnt, rows(0.0, 1U));
    EXPECT_EQ(learnt, rows(30.0, 3U));
}

}  // namespace
}  // namespace learning_drive_test
