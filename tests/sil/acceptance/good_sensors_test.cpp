// Good sensors on difficult roads: no code is set. Beyond the calibration's limits, one is.
#include <gtest/gtest.h>

#include "sil/units.hpp"
#include "sil/world/vehicle/uneven_road.hpp"
#include "tests/sil/acceptance/closed_run.hpp"

namespace rsi_test {
namespace good_sensors_test {
namespace {

using Code = rsi::can_dbc::RolloverDiagnosis::Code;

// The bank comes and goes within so many metres, at 80 km/h.
RunSettings on_a_twisting_road(const std::string& vehicle, double bank_deg, double transition_m) {
    RunSettings settings;
    settings.manoeuvre = "banked-straight";
    settings.vehicle = vehicle;
    settings.noise = true;
    settings.road = [bank_deg, transition_m](std::uint64_t) {
        return std::make_unique<sil::BankedStretchRoad>(sil::from_degrees(bank_deg), 50.0, 390.0,
                                                        transition_m);
    };
    return settings;
}

RunSettings over_high_bumps(const std::string& vehicle) {
    RunSettings settings;
    settings.manoeuvre = "one-sided-bump";
    settings.vehicle = vehicle;
    settings.noise = true;
    settings.road = [](std::uint64_t) {
        return std::make_unique<sil::OneSidedBumpRoad>(0.08, 3.0, 20.0, 25.0, 3);
    };
    return settings;
}

// Within a second, and within 1.35 s. No road is built like that; beyond it the body swings so much on its
// springs that roll rate and roll angle are taken to contradict each other.
std::vector<RunSettings> roads_that_try_sensors(const std::string& vehicle) {
    return {on_a_twisting_road(vehicle, 10.0, 80.0 / 3.6), on_a_twisting_road(vehicle, 12.0, 30.0),
            over_high_bumps(vehicle)};
}

void make_coarse(sil::SensorOptions& sensors) {
    sensors.roll.roll_angle_rad.quantisation_step = sil::from_degrees(0.5);
    sensors.imu.roll_rate_radps.quantisation_step = sil::from_degrees(0.5);
    sensors.motion.yaw_rate_radps.quantisation_step = sil::from_degrees(0.5);
    sensors.motion.speed_mps.quantisation_step = 1.0 / 3.6;
}

void take_off_the_filters(sil::SensorOptions& sensors) {
    sensors.imu.averaged = false;
    sensors.imu.lateral_acceleration_mps2.noise_rms = 1.0;
    sensors.imu.vertical_acceleration_mps2.noise_rms = 1.0;
}

struct Kind {
    const char* name;
    std::function<void(sil::SensorOptions&)> sensors;
    std::vector<std::string> calibration;  // the calibration's limits
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {"usual", {}, {}},
        {"coarse", make_coarse, {"speed_resolution_mps=0.278"}},
        {"without a filter", take_off_the_filters, {"accelerometer_noise_mps2=1.0"}}};
    return all;
}

class GoodSensors : public testing::TestWithParam<std::string> {};

TEST_P(GoodSensors, SetNoCodeWhereTheRoadTwistsOrBumps) {
    for (const Kind& kind : kinds()) {
        for (RunSettings settings : roads_that_try_sensors(GetParam())) {
            SCOPED_TRACE(settings.manoeuvre + ", " + kind.name);
            settings.sensors = kind.sensors;
            settings.changes = kind.calibration;
            const RunResult run = drive(settings);
            for (const Code code : run.confirmed_codes) {
                ADD_FAILURE() << rsi::can_dbc::RolloverDiagnosis::name_of(code);
            }
            EXPECT_EQ(run.events.judgement.unavailable_s, 0.0);
            EXPECT_EQ(run.events.judgement.warnings, 0U);
        }
    }
}

TEST_P(GoodSensors, ThatTheCalibrationTakesForQuieterOnesSetACode) {
    RunSettings settings = on_a_twisting_road(GetParam(), 6.0, 40.0);
    settings.sensors = take_off_the_filters;
    const RunResult run = drive(settings);
    EXPECT_EQ(run.confirmed_codes.count(Code::lateral_acceleration_jump), 1U);
    EXPECT_EQ(run.events.judgement.warnings, 0U);
}

// Without noise a speed that stands still is not known from one that does not change.
TEST_P(GoodSensors, WhoseSpeedIsCoarserThanTheCalibrationSaysSetNoCode) {
    RunSettings settings;
    settings.manoeuvre = "slalom";
    settings.vehicle = GetParam();
    settings.sensors = make_coarse;
    const RunResult run = drive(settings);
    EXPECT_TRUE(run.confirmed_codes.empty());
}

INSTANTIATE_TEST_SUITE_P(OfEachVehicle, GoodSensors, testing::Values("large_suv", "ordinary_suv", "van"),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace good_sensors_test
}  // namespace rsi_test
