// Drawn run: the firmware's values are wrong by what was drawn, counted from the loaded vehicle.
#include "sil/studies/campaign/drawn_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "rsi/parameters.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/studies/campaign/campaign_run.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/sensors/sensor_suite.hpp"
#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/sil/campaign/small_campaign.hpp"

namespace {

using testing_campaign::project_file;
using testing_campaign::small_campaign;

constexpr double float_rounding = 1.0e-6;

TEST(DrawnRun, TheFirmwareIsToldTheTruthTimesOnePlusTheError) {
    const sil::CampaignWorld world{small_campaign(50U)};
    const rsi::Parameters calibrations[] = {
        sil::load_calibration(project_file("firmware/calibrations/large_suv.toml")),
        sil::load_calibration(project_file("firmware/calibrations/ordinary_suv.toml"))};
    for (std::uint64_t number = 0U; number < 50U; ++number) {
        const sil::DrawnRun run = world.prepare(number);
        const rsi::Parameters& nominal = calibrations[run.draw.vehicle];
        EXPECT_NEAR(static_cast<double>(run.calibration.sprung_mass_kg) / run.vehicle.mass.sprung_kg,
                    1.0 + run.draw.mass_error, float_rounding);
        EXPECT_NEAR(
            static_cast<double>(run.calibration.sprung_cg_height_m) / run.vehicle.geometry.cg_height_m,
            1.0 + run.draw.cg_height_error, float_rounding);
        EXPECT_NEAR(static_cast<double>(run.calibration.roll_stiffness_nmprad) /
                        static_cast<double>(nominal.roll_stiffness_nmprad),
                    1.0 + run.draw.stiffness_error, float_rounding);
        EXPECT_NEAR(static_cast<double>(run.calibration.roll_stiffness_quintic_nmprad5) /
                        static_cast<double>(nominal.roll_stiffness_quintic_nmprad5),
                    1.0 + run.draw.stiffness_error, float_rounding);
        EXPECT_EQ(run.calibration.track_width_m, nominal.track_width_m);
        EXPECT_EQ(run.calibration.imu_z_m, nominal.imu_z_m);
    }
}

// identify matches the height to the wheel loads: beyond the CG's where tyres give sideways.
TEST(DrawnRun, ErrorsCountFromTheCalibrationWhichALoadChangesAsItChangesTheVehicle) {
    const sil::VehicleParameters built = sil::load_vehicle(project_file("sil/vehicles/large_suv.toml"));
    rsi::Parameters matched = sil::load_calibration(project_file("firmware/calibrations/large_suv.toml"));
    matched.sprung_cg_height_m *= 1.08F;
    matched.sprung_mass_kg *= 0.98F;
    sil::RunDraw draw;
    draw.cg_height_error = -0.05;
    draw.load_height_factor = 1.5;
    for (const double load_share : {0.0, 0.2}) {
        draw.load_share = load_share;
        const sil::DrawnRun run = sil::drawn_run(small_campaign(1U), draw, built, matched, sil::Manoeuvre{});
        EXPECT_NEAR(static_cast<double>(run.calibration.sprung_cg_height_m / matched.sprung_cg_height_m),
                    0.95 * run.vehicle.geometry.cg_height_m / built.geometry.cg_height_m, float_rounding);
        EXPECT_NEAR(static_cast<double>(run.calibration.sprung_mass_kg / matched.sprung_mass_kg),
                    run.vehicle.mass.sprung_kg / built.mass.sprung_kg, float_rounding);
    }
}

// The references of the paper's rollover index follow from height and stiffness.
TEST(DrawnRun, WrongHeightAndStiffnessMakeWrongReferencesOfTheRolloverIndex) {
    const sil::VehicleParameters built = sil::load_vehicle(project_file("sil/vehicles/large_suv.toml"));
    const rsi::Parameters given = sil::load_calibration(project_file("firmware/calibrations/large_suv.toml"));
    const auto with = [&](double height_error, double stiffness_error) {
        sil::RunDraw draw;
        draw.cg_height_error = height_error;
        draw.stiffness_error = stiffness_error;
        return sil::drawn_run(small_campaign(1U), draw, built, given, sil::Manoeuvre{}).calibration;
    };
    const rsi::Parameters exact = with(0.0, 0.0);
    EXPECT_NEAR(exact.rollover_index_roll_angle_rad, given.rollover_index_roll_angle_rad, 1.0e-6F);
    EXPECT_NEAR(exact.rollover_index_acceleration_mps2, given.rollover_index_acceleration_mps2, 1.0e-5F);
    // A higher CG lifts the wheels at less acceleration, a stiffer body at less roll.
    const float higher =
        with(0.05, 0.0).rollover_index_acceleration_mps2 / exact.rollover_index_acceleration_mps2;
    EXPECT_GT(higher, 0.93F);
    EXPECT_LT(higher, 0.96F);
    const float stiffer = with(0.0, 0.1).rollover_index_roll_angle_rad / exact.rollover_index_roll_angle_rad;
    EXPECT_GT(stiffer, 0.85F);
    EXPECT_LT(stiffer, 0.93F);
}

TEST(DrawnRun, TellsTheCodesThatItsSensorsSet) {
    sil::CampaignSettings settings = small_campaign(1U);
    settings.spread.accelerometer_bias_g = 0.0;
    EXPECT_EQ(sil::CampaignWorld{settings}.run(0U).codes, 0U);
    settings.spread.accelerometer_bias_g = 2.0;
    EXPECT_NE(sil::CampaignWorld{settings}.run(0U).codes, 0U);
}

TEST(DrawnRun, ARoughRoadIsDrawnAnewForEachRun) {
    sil::CampaignSettings settings = small_campaign(2U);
    settings.manoeuvres = {{"rough-turn", 1.0, {1.0, 1.0}, {1.0, 1.0}, 12.0}};
    const sil::CampaignWorld world{settings};
    const auto height_m = [&world](std::uint64_t number) {
        const sil::DrawnRun run = world.prepare(number);
        return run.manoeuvre.make_road(run.options.road_seed)->at(40.0, 1.0).height_m;
    };
    EXPECT_NE(height_m(0U), height_m(1U));
    EXPECT_EQ(height_m(1U), height_m(1U));
}

TEST(DrawnRun, AnUnknownLoadIsNoPartOfTheError) {
    sil::CampaignSettings settings = small_campaign(20U);
    settings.spread.load_share = {0.2, 0.3};
    settings.spread.load_is_known = false;
    const sil::CampaignWorld world{settings};
    const rsi::Parameters calibrations[] = {
        sil::load_calibration(project_file("firmware/calibrations/large_suv.toml")),
        sil::load_calibration(project_file("firmware/calibrations/ordinary_suv.toml"))};
    for (std::uint64_t number = 0U; number < 20U; ++number) {
        const sil::DrawnRun run = world.prepare(number);
        const rsi::Parameters& nominal = calibrations[run.draw.vehicle];
        EXPECT_NEAR(static_cast<double>(run.calibration.sprung_mass_kg / nominal.sprung_mass_kg),
                    1.0 + run.draw.mass_error, float_rounding);
        EXPECT_NEAR(static_cast<double>(run.calibration.sprung_cg_height_m / nominal.sprung_cg_height_m),
                    1.0 + run.draw.cg_height_error, float_rounding);
    }
}

TEST(DrawnRun, AChangeTakesThePlaceOfWhatEveryCalibrationSays) {
    sil::CampaignSettings settings = small_campaign(10U);
    settings.changes = {"warning_on=0.95", "warning_hold_s=1.5"};
    const sil::CampaignWorld world{settings};
    for (std::uint64_t number = 0U; number < 10U; ++number) {
        EXPECT_EQ(world.prepare(number).calibration.warning_on, 0.95F);
        EXPECT_EQ(world.prepare(number).calibration.warning_hold_s, 1.5F);
    }
    settings.changes = {"warning_own=0.95"};
    EXPECT_THROW(sil::CampaignWorld{settings}, sil::InputError);
}

TEST(DrawnRun, AStifferBodyKeepsTheLeastDampingThatTheComponentAdmits) {
    const sil::VehicleParameters built = sil::load_vehicle(project_file("sil/vehicles/large_suv.toml"));
    rsi::Parameters calibration = sil::load_calibration(project_file("firmware/calibrations/large_suv.toml"));
    calibration.roll_damping_nmsprad = 0.00505F * calibration.roll_stiffness_nmprad;
    sil::RunDraw draw;
    draw.stiffness_error = 0.1;
    const sil::DrawnRun run = sil::drawn_run(small_campaign(1U), draw, built, calibration, sil::Manoeuvre{});
    EXPECT_EQ(rsi::validate(run.calibration).accepted, 1);
    draw.stiffness_error = -0.1;
    EXPECT_EQ(sil::drawn_run(small_campaign(1U), draw, built, calibration, sil::Manoeuvre{})
                  .calibration.roll_damping_nmsprad,
              calibration.roll_damping_nmsprad);
}

TEST(DrawnRun, ASensorThatIsNotThereSaysNotAvailable) {
    sil::CampaignSettings settings = small_campaign(1U);
    const sil::DrawnRun whole = sil::CampaignWorld{settings}.prepare(0U);
    settings.spread.steering_sensor = false;
    settings.spread.roll_sensor = false;
    const sil::DrawnRun without = sil::CampaignWorld{settings}.prepare(0U);
    const sil::Truth truth;
    for (const auto& [run, available] : {std::pair{&whole, true}, std::pair{&without, false}}) {
        sil::SensorSuite sensors{run->sensors};
        sensors.observe(truth);
        const sil::SensorSample sample = sensors.report(truth);
        EXPECT_EQ(std::isfinite(sample.steering_wheel_angle_rad), available);
        EXPECT_EQ(std::isfinite(sample.roll_angle_rad), available);
        EXPECT_TRUE(std::isfinite(sample.roll_rate_radps));
    }
}

TEST(DrawnRun, AnAttitudeSensorIsMountedWhereTheSettingsSaySo) {
    sil::CampaignSettings settings = small_campaign(1U);
    EXPECT_EQ(sil::CampaignWorld{settings}.prepare(0U).sensors.roll.reference, sil::RollReference::road);
    settings.spread.attitude_sensor = true;
    EXPECT_EQ(sil::CampaignWorld{settings}.prepare(0U).sensors.roll.reference, sil::RollReference::horizon);
}

// The mass of one run as its sensors report it.
double reported_mass_kg(const sil::CampaignSettings& settings) {
    const sil::DrawnRun run = sil::CampaignWorld{settings}.prepare(0U);
    sil::SensorSuite sensors{run.sensors};
    sil::Truth truth;
    truth.mass_kg = 1000.0;
    return sensors.report(truth).vehicle_mass_kg;
}

TEST(DrawnRun, AMassSensorIsFittedWhereTheVehicleHasOneAndIsWrongWithNoise) {
    sil::CampaignSettings settings = small_campaign(1U);
    EXPECT_TRUE(std::isnan(reported_mass_kg(settings)));
    for (sil::CampaignVehicle& vehicle : settings.vehicles) {
        vehicle.mass_sensor = true;
    }
    const double error = sil::CampaignWorld{settings}.prepare(0U).draw.mass_sensor_error;
    EXPECT_NE(error, 0.0);
    EXPECT_EQ(reported_mass_kg(settings), 1000.0 * (1.0 + error));
    settings.spread.sensor_noise = false;
    EXPECT_EQ(reported_mass_kg(settings), 1000.0);
}

TEST(DrawnRun, SensorsSitWhereAndAsTheDrawSays) {
    const sil::CampaignSettings settings = small_campaign(1U);
    const sil::VehicleParameters vehicle = sil::load_vehicle(project_file("sil/vehicles/large_suv.toml"));
    sil::RunDraw draw;
    const sil::ImuOptions as_built = sil::drawn_sensors(settings, draw, vehicle).imu;
    EXPECT_EQ(as_built.position.z_m, vehicle.imu_mount.z_m);
    EXPECT_EQ(as_built.tilt.roll_rad, 0.0);
    draw.housing_tilt_deg = {1.0, -2.0, 1.5};
    draw.lever_arm_error_m = {0.1, -0.05, 0.02};
    const sil::ImuOptions drawn = sil::drawn_sensors(settings, draw, vehicle).imu;
    EXPECT_NEAR(drawn.position.x_m, vehicle.imu_mount.x_m + 0.1, 1e-12);
    EXPECT_NEAR(drawn.position.y_m, vehicle.imu_mount.y_m - 0.05, 1e-12);
    EXPECT_NEAR(drawn.position.z_m, vehicle.imu_mount.z_m + 0.02, 1e-12);
    EXPECT_NEAR(drawn.tilt.roll_rad, 1.0 * 3.14159265358979 / 180.0, 1e-12);
    EXPECT_NEAR(drawn.tilt.pitch_rad, -2.0 * 3.14159265358979 / 180.0, 1e-12);
    EXPECT_NEAR(drawn.tilt.yaw_rad, 1.5 * 3.14159265358979 / 180.0, 1e-12);
}

// Largest speed of the hands in a run, deg/s.
double fastest_hands_degps(const sil::DrawnRun& drawn) {
    sil::ManoeuvreRun run{drawn.vehicle, drawn.manoeuvre, drawn.options};
    double fastest = 0.0;
    double before = 0.0;
    while (!run.finished()) {
        run.step();
        const double now = run.truth().steering_wheel_angle_rad * sil::degrees_per_radian;
        fastest = std::max(fastest, std::abs(now - before) / run.step_s());
        before = now;
    }
    return fastest;
}

TEST(DrawnRun, HandsTurnAtTheDrawnRateWhateverTheAngle) {
    const sil::VehicleParameters built = sil::load_vehicle(project_file("sil/vehicles/large_suv.toml"));
    for (const char* const name : {"j-turn-110", "j-turn-45", "fishhook-1a", "fishhook-1b", "step-steer"}) {
        sil::RunDraw draw;
        draw.steering_factor = 0.4;
        const sil::Manoeuvre manoeuvre = sil::find_manoeuvre(name);
        const double own =
            fastest_hands_degps(sil::drawn_run(small_campaign(1U), draw, built, {}, manoeuvre));
        for (const double rate : {300.0, 1200.0}) {
            draw.handwheel_rate_degps = rate;
            const double fastest =
                fastest_hands_degps(sil::drawn_run(small_campaign(1U), draw, built, {}, manoeuvre));
            EXPECT_NEAR(fastest, rate, 1.0e-6 * rate) << name;
        }
        EXPECT_LT(own, 300.0) << name;
    }
}

TEST(DrawnRun, ALoadChangesTheTrueVehicle) {
    const sil::VehicleParameters built = sil::load_vehicle(project_file("sil/vehicles/large_suv.toml"));
    sil::CampaignSettings settings = small_campaign(1U);
    sil::RunDraw draw;
    draw.load_share = 0.05;
    draw.load_height_factor = 1.9;
    draw.friction_factor = 0.8;
    const sil::DrawnRun run = sil::drawn_run(settings, draw, built, {}, sil::Manoeuvre{});
    EXPECT_NEAR(run.vehicle.mass.sprung_kg, 1.05 * built.mass.sprung_kg, 1.0e-9);
    // (1 * h + 0.05 * 1.9 h) / 1.05
    EXPECT_NEAR(run.vehicle.geometry.cg_height_m, built.geometry.cg_height_m * 1.095 / 1.05, 1.0e-9);
    EXPECT_NEAR(run.vehicle.tyre.friction, 0.8 * built.tyre.friction, 1.0e-9);
}

TEST(DrawnRun, AManoeuvresOwnChangeOfTheVehicleIsMadeOnceAndBeforeTheLoad) {
    const sil::VehicleParameters built = sil::load_vehicle(project_file("sil/vehicles/large_suv.toml"));
    sil::Manoeuvre manoeuvre;
    manoeuvre.adapt_vehicle = [](sil::VehicleParameters vehicle) {
        vehicle.geometry.cg_height_m += 0.2;
        return vehicle;
    };
    sil::RunDraw draw;
    draw.cg_height_error = 0.04;
    const rsi::Parameters calibration =
        sil::load_calibration(project_file("firmware/calibrations/large_suv.toml"));
    const sil::DrawnRun run = sil::drawn_run(small_campaign(1U), draw, built, calibration, manoeuvre);
    EXPECT_NEAR(run.vehicle.geometry.cg_height_m, built.geometry.cg_height_m + 0.2, 1.0e-9);
    EXPECT_NEAR(static_cast<double>(run.calibration.sprung_cg_height_m),
                1.04 * (built.geometry.cg_height_m + 0.2), float_rounding);
    EXPECT_FALSE(run.manoeuvre.adapt_vehicle);
}

}  // namespace
