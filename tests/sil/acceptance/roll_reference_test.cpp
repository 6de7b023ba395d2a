// An attitude sensor in place of one of the suspension: with the right setting the warning is as good, with
// the wrong one the ECU says so.
#include <gtest/gtest.h>

#include "sil/files/calibration_file.hpp"
#include "tests/sil/acceptance/closed_run.hpp"

namespace rsi_test {
namespace roll_reference_test {
namespace {

using Code = rsi::can_dbc::RolloverDiagnosis::Code;

RunSettings with_noise(const std::string& manoeuvre, const std::string& vehicle) {
    RunSettings settings;
    settings.manoeuvre = manoeuvre;
    settings.vehicle = vehicle;
    settings.noise = true;
    return settings;
}

RunSettings with_attitude_sensor(RunSettings settings) {
    settings.attitude_sensor = true;
    settings.changes.emplace_back("roll_angle_reference=horizon");
    return settings;
}

// The manoeuvre raises the body; a calibration is for the load that is driven.
std::string raised_height(const std::string& vehicle) {
    const rsi::Parameters calibration =
        sil::load_calibration(std::string{RSI_SOURCE_DIR} + "/firmware/calibrations/" + vehicle + ".toml");
    return "sprung_cg_height_m=" + std::to_string(calibration.sprung_cg_height_m + 0.112F);
}

class AttitudeSensor : public testing::TestWithParam<std::string> {};

// On level and on banked roads, with lift-off and without.
TEST_P(AttitudeSensor, WarnsAsOneOfTheSuspensionDoes) {
    for (const char* manoeuvre :
         {"banked-straight", "j-turn-banked", "j-turn-110", "j-turn-45", "fishhook-1a", "fishhook-1b",
          "sine-with-dwell", "double-lane-change", "slalom", "rough-turn", "braking-in-turn"}) {
        for (const bool bank_sensor : {false, true}) {
            SCOPED_TRACE(std::string{manoeuvre} + (bank_sensor ? " with bank sensor" : ""));
            RunSettings settings = with_noise(manoeuvre, GetParam());
            settings.bank_sensor = bank_sensor;
            if (settings.manoeuvre == "j-turn-banked") {
                settings.changes.push_back(raised_height(GetParam()));
            }
            const RunResult road = drive(settings);
            const RunResult horizon = drive(with_attitude_sensor(settings));
            const sil::WarningJudgement& expected = road.events.judgement;
            const sil::WarningJudgement& judged = horizon.events.judgement;
            EXPECT_EQ(judged.lifted, expected.lifted);
            EXPECT_EQ(judged.lead_s.has_value(), expected.lead_s.has_value());
            if (judged.lead_s && expected.lead_s) {
                EXPECT_GT(*judged.lead_s, *expected.lead_s - 0.05);
            }
            // Nearer to lift-off, a hair's breadth decides.
            if (expected.band() < sil::LoadBand::from_0_8) {
                EXPECT_LE(judged.warnings, expected.warnings);
            }
            EXPECT_EQ(judged.unavailable_s, 0.0);
            EXPECT_EQ(horizon.confirmed_codes, road.confirmed_codes);
        }
    }
}

TEST_P(AttitudeSensor, SetForOneOfTheSuspensionIsNoticedOnABankedRoad) {
    for (const bool bank_sensor : {false, true}) {
        RunSettings settings = with_noise("banked-straight", GetParam());
        settings.bank_sensor = bank_sensor;
        settings.attitude_sensor = true;
        const RunResult run = drive(settings);
        EXPECT_EQ(run.confirmed_codes.count(Code::roll_angle_reference_wrong), 1U) << bank_sensor;
        EXPECT_EQ(run.events.judgement.warnings, 0U);
    }
}

TEST_P(AttitudeSensor, IsMissedWhereOneOfTheSuspensionIsSetForIt) {
    for (const bool bank_sensor : {false, true}) {
        RunSettings settings = with_noise("banked-straight", GetParam());
        settings.bank_sensor = bank_sensor;
        settings.changes.emplace_back("roll_angle_reference=horizon");
        const RunResult run = drive(settings);
        EXPECT_EQ(run.confirmed_codes.count(Code::roll_angle_reference_wrong), 1U) << bank_sensor;
        EXPECT_EQ(run.events.judgement.warnings, 0U);
    }
}

INSTANTIATE_TEST_SUITE_P(OfEachVehicle, AttitudeSensor, testing::Values("large_suv", "ordinary_suv", "van"),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace roll_reference_test
}  // namespace rsi_test
