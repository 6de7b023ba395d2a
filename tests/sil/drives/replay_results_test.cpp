// Replay results: indices, warnings, summary, verdict and table of an invented replay.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sil/results/summary.hpp"
#include "sil/studies/drives/felt_load_transfer.hpp"
#include "sil/studies/drives/replay_csv.hpp"
#include "sil/studies/drives/replay_summary.hpp"
#include "sil/studies/drives/replay_table.hpp"
#include "sil/studies/drives/verdict.hpp"
#include "sil/units.hpp"
#include "tests/sil/drives/recorded_drive.hpp"

namespace {

using sil::DriveSample;
using sil::Verdict;
using sil::WarningSide;
using sil::WarningState;

sil::ReplayCycle cycle(double time_s, WarningState state, WarningSide side) {
    sil::ReplayCycle result;
    result.sample.time_s = time_s;
    result.sample.roll_angle_rad = 0.1;
    result.ecu.warning().state = state;
    result.ecu.warning().side = side;
    result.outputs.state = static_cast<std::int32_t>(state);
    result.outputs.side = static_cast<std::int32_t>(side);
    result.outputs.rsi = 0.75F;
    result.outputs.lateral_acceleration_mps2 = std::numeric_limits<float>::quiet_NaN();
    result.ecu.of<rsi::can_dbc::RolloverDiagnosis>().degradation =
        rsi::can_dbc::RolloverDiagnosis::Degradation::full;
    return result;
}

sil::DriveReplay three_cycles() {
    sil::DriveReplay replay;
    replay.cycles = {cycle(0.0, WarningState::ready, WarningSide::none),
                     cycle(0.01, WarningState::ready, WarningSide::none),
                     cycle(0.02, WarningState::warning, WarningSide::right)};
    const auto bit = [](rsi::can_dbc::RolloverDiagnosis::Code code) {
        return std::uint64_t{1U} << static_cast<unsigned>(code);
    };
    const std::uint64_t lost = bit(rsi::can_dbc::RolloverDiagnosis::Code::imu_lost);
    const std::uint64_t stuck = bit(rsi::can_dbc::RolloverDiagnosis::Code::speed_stuck);
    replay.cycles[2].codes = {lost | stuck, stuck};
    replay.confirmed_codes = stuck;
    replay.events.warning = sil::EventMoment{0.02, 6.0, 0.1};
    replay.events.warning_side = WarningSide::right;
    replay.events.end_time_s = 0.02;
    return replay;
}

std::vector<std::vector<std::string>> cells(const std::string& csv) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines{csv};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields{line + ","};
        rows.emplace_back();
        for (std::string field; std::getline(fields, field, ',');) {
            rows.back().push_back(field);
        }
    }
    return rows;
}

TEST(WarningsCsv, HasOneRowForEveryChange) {
    EXPECT_EQ(sil::warnings_csv(three_cycles()), "time_s,state,side\n0,ready,none\n0.02,warning,right\n");
}

TEST(DiagnosisCsv, HasOneRowForEveryChange) {
    EXPECT_EQ(sil::diagnosis_csv(three_cycles()),
              "time_s,degradation,codes_set,codes_confirmed\n0,full,,\n"
              "0.02,full,imu lost; speed stuck,speed stuck\n");
}

TEST(IndicesCsv, HasAFieldForEveryColumnInEveryCycle) {
    const auto rows = cells(sil::indices_csv(three_cycles()));
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[0], sil::indices_csv_columns());
    for (const auto& row : rows) {
        EXPECT_EQ(row.size(), rows[0].size());
    }
    const auto value = [&](const char* name) {
        const auto column = std::find(rows[0].begin(), rows[0].end(), name);
        return column == rows[0].end() ? "no column"
                                       : rows[3][static_cast<std::size_t>(column - rows[0].begin())];
    };
    EXPECT_EQ(value("time_s"), "0.02");
    EXPECT_EQ(value("rsi"), "0.75");
    EXPECT_EQ(value("sensor_roll_angle_deg"), "5.72957795");
    EXPECT_EQ(value("lateral_acceleration_mps2"), "");  // NaN: not available
    EXPECT_EQ(value("sensor_bank_angle_deg"), "");
    EXPECT_EQ(value("state"), "warning");
    EXPECT_EQ(value("state_number"), "3");
    EXPECT_EQ(value("side"), "right");
    EXPECT_EQ(value("degradation"), "full");
    EXPECT_EQ(value("codes_set"), "imu lost; speed stuck");
    EXPECT_EQ(value("codes_confirmed"), "speed stuck");
}

TEST(ReplaySummary, HasTheKeysOfARunInTheirOrderAndThenItsOwn) {
    const std::string text =
        sil::replay_summary_json({"slalom", "a/slalom.csv", "csv", "large_suv", {"gear"}}, three_cycles(),
                                 testing_drives::large_suv_calibration());
    const auto json = nlohmann::ordered_json::parse(text);
    const auto of_a_run = nlohmann::ordered_json::parse(sil::summary_json({}));
    auto own = json.begin();
    for (auto key = of_a_run.begin(); key != of_a_run.end(); ++key, ++own) {
        EXPECT_EQ(own.key(), key.key());
    }
    EXPECT_EQ(json["manoeuvre"], "slalom");
    EXPECT_EQ(json["vehicle"], "large_suv");
    EXPECT_TRUE(json["seed"].is_null());
    EXPECT_EQ(json["warning_time_s"], 0.02);
    EXPECT_EQ(json["warning_side"], "right");
    EXPECT_TRUE(json["two_wheel_lift_time_s"].is_null());
    EXPECT_EQ(json["file"], "a/slalom.csv");
    EXPECT_EQ(json["verdict"], "warning");
    EXPECT_EQ(json["lift_off_source"], "unknown");
    EXPECT_TRUE(json["largest_load_transfer_ratio"].is_null());
    EXPECT_EQ(json["cycles"], 3);
    EXPECT_EQ(json["confirmed_codes"].dump(), "[\"speed stuck\"]");
    EXPECT_EQ(json["ignored_columns"].dump(), "[\"gear\"]");
}

sil::DriveReplay outcome(std::optional<double> warning_s, std::optional<double> one_s,
                         std::optional<double> two_s, double largest_ratio = 0.5) {
    sil::DriveReplay replay;
    const auto moment = [](const std::optional<double>& time_s) {
        return time_s ? std::optional<sil::EventMoment>{sil::EventMoment{*time_s, 0.0, 0.0}} : std::nullopt;
    };
    replay.events.warning = moment(warning_s);
    replay.events.one_wheel_lift = moment(one_s);
    replay.events.two_wheel_lift = moment(two_s);
    replay.lift_off.source = sil::LiftOffSource::given;
    replay.largest_load_transfer_ratio = largest_ratio;
    return replay;
}

// The wheels have lifted and the vehicle falls to the right.
sil::DriveReplay lifted(WarningSide side_at_lift_off, std::optional<double> lead_s, bool late = false) {
    sil::DriveReplay replay = outcome(1.0, 1.1, 1.2);
    sil::WarningJudgement& judgement = replay.events.judgement;
    judgement.lifted = true;
    judgement.falling_side = WarningSide::right;
    judgement.side_at_lift_off = side_at_lift_off;
    judgement.lead_s = lead_s;
    judgement.late = late;
    return replay;
}

TEST(Verdict, OfALiftOffIsThatOfTheWarningInForce) {
    EXPECT_EQ(sil::verdict(lifted(WarningSide::right, 0.2)), Verdict::ahead);
    EXPECT_EQ(sil::verdict(lifted(WarningSide::right, 0.0)), Verdict::ahead);
    EXPECT_EQ(sil::verdict(lifted(WarningSide::left, {})), Verdict::wrong_side);
    EXPECT_EQ(sil::verdict(lifted(WarningSide::left, {}, true)), Verdict::wrong_side);
    EXPECT_EQ(sil::verdict(lifted(WarningSide::none, {}, true)), Verdict::late);
    EXPECT_EQ(sil::verdict(lifted(WarningSide::none, {})), Verdict::missed) << "one that came and went";
    EXPECT_STREQ(to_string(Verdict::wrong_side), "wrong side");
}

TEST(Verdict, TellsWhatTheWarningWasWorth) {
    EXPECT_EQ(sil::verdict(outcome(1.0, 1.1, {})), Verdict::one_wheel_alarm);
    EXPECT_EQ(sil::verdict(outcome(1.0, {}, {}, 0.9)), Verdict::near_alarm);
    EXPECT_EQ(sil::verdict(outcome(1.0, {}, {}, 0.899)), Verdict::false_alarm);
    EXPECT_EQ(sil::verdict(outcome(1.0, {}, {}, sil::EcuOutput::not_available)), Verdict::false_alarm);
    EXPECT_EQ(sil::verdict(outcome({}, {}, {})), Verdict::quiet);
    EXPECT_EQ(sil::verdict(outcome({}, 1.1, {})), Verdict::quiet);
}

TEST(Verdict, IsNotQuietWhileThereCouldBeNoWarning) {
    sil::DriveReplay replay = outcome({}, {}, {});
    replay.events.judgement.unavailable_s = 0.01;
    EXPECT_EQ(sil::verdict(replay), Verdict::unavailable);
    EXPECT_STREQ(to_string(Verdict::unavailable), "unavailable");
    replay.lift_off.source = sil::LiftOffSource::unknown;
    EXPECT_EQ(sil::verdict(replay), Verdict::unavailable);
    replay.events.warning = sil::EventMoment{};
    EXPECT_EQ(sil::verdict(replay), Verdict::warning);
}

TEST(Verdict, SaysNothingOfLiftOffThatIsNotKnown) {
    sil::DriveReplay replay = outcome(1.0, {}, {});
    replay.lift_off.source = sil::LiftOffSource::unknown;
    EXPECT_EQ(sil::verdict(replay), Verdict::warning);
    replay.events.warning.reset();
    EXPECT_EQ(sil::verdict(replay), Verdict::no_warning);
}

sil::ReplayWarning warned(WarningSide side, double time_s, double largest_load_transfer_ratio = 0.9) {
    return {{time_s, time_s, side}, largest_load_transfer_ratio};
}

TEST(Verdict, WithoutWheelLoadsAWarningWhereNoneCanHaveLiftedIsFalse) {
    sil::DriveReplay replay = outcome(1.0, {}, {});
    replay.lift_off.source = sil::LiftOffSource::unknown;
    replay.warnings = {warned(WarningSide::left, 1.0, 0.7),
                       warned(WarningSide::left, 2.0, sil::EcuOutput::not_available)};
    EXPECT_EQ(sil::verdict(replay), Verdict::warning);
    replay.warnings.push_back(warned(WarningSide::right, 3.0, 0.69));
    EXPECT_EQ(sil::verdict(replay), Verdict::false_alarm);
    replay.lift_off.source = sil::LiftOffSource::given;
    replay.largest_load_transfer_ratio = 0.9;
    EXPECT_EQ(sil::verdict(replay), Verdict::near_alarm) << "the wheel loads count where they are known";
}

TEST(FeltLoadTransfer, IsTheLargestAboutTheWarning) {
    rsi::Parameters parameters = testing_drives::large_suv_calibration();
    parameters.sprung_mass_kg = 1800.0F;
    parameters.unsprung_mass_kg = 200.0F;
    parameters.sprung_cg_height_m = 0.9F;
    parameters.unsprung_cg_height_m = 0.4F;
    parameters.track_width_m = 1.7F;
    const double share = sil::height_share(parameters);
    EXPECT_NEAR(share, 1.0, 1e-6);
    std::vector<sil::ReplayCycle> cycles;
    for (int number = 0; number < 500; ++number) {
        cycles.push_back(cycle(0.01 * number, WarningState::ready, WarningSide::none));
        DriveSample& sample = cycles.back().sample;
        sample.lateral_acceleration_mps2 = number < 90 ? 9.0 : (number < 330 ? -3.0 : 6.0);
        sample.vertical_acceleration_mps2 = 10.0;
    }
    const auto felt = [&](double begin_s, double end_s) {
        return sil::felt_load_transfer(cycles, share, {begin_s, end_s, WarningSide::left});
    };
    EXPECT_NEAR(felt(2.0, 2.1), 0.3, 1e-6);
    EXPECT_NEAR(felt(1.8, 2.1), 0.9, 1e-6) << "within a second before";
    EXPECT_NEAR(felt(2.0, 2.31), 0.6, 1e-6) << "within a second after";
    EXPECT_TRUE(std::isnan(felt(8.0, 9.0)));
    cycles[205].sample.lateral_acceleration_mps2 = 1000.0;
    EXPECT_NEAR(felt(2.0, 2.1), (9.0 * 3.0 - 1000.0) / -100.0, 1e-5) << "a mean";
    for (sil::ReplayCycle& each : cycles) {
        each.sample.vertical_acceleration_mps2 = sil::EcuOutput::not_available;
        each.sample.lateral_acceleration_mps2 = -0.5 * sil::g_mps2;
    }
    EXPECT_NEAR(felt(2.0, 2.1), 0.5, 1e-6) << "g where no vertical acceleration is known";
}

TEST(ReplayTable, NamesTheSideOfEveryWarning) {
    sil::DriveReplay replay = lifted(WarningSide::right, 0.25);
    replay.warnings = {warned(WarningSide::right, 1.0), warned(WarningSide::left, 2.5)};
    const sil::ReplayRow row = sil::replay_row("x.csv", "x", replay);
    EXPECT_THAT(sil::table_csv({row}), testing::HasSubstr(",ahead,,right at 1.000 s; left at 2.500 s\n"));
    EXPECT_THAT(sil::table_text({row}), testing::HasSubstr("  ahead: right at 1.000 s; left at 2.500 s\n"));
    replay.warnings.insert(replay.warnings.end(), 2U, warned(WarningSide::left, 3.0));
    EXPECT_EQ(sil::first_warnings(sil::all_warnings(replay)), sil::all_warnings(replay));
    replay.warnings.insert(replay.warnings.end(), 2U, warned(WarningSide::left, 4.0));
    EXPECT_EQ(sil::first_warnings(sil::all_warnings(replay)),
              "right at 1.000 s; left at 2.500 s; left at 3.000 s; left at 3.000 s; 2 more");
}

TEST(ReplayTable, HasARowForEveryFileAlsoForFailedOnes) {
    sil::DriveReplay replay = lifted(WarningSide::right, 0.25);
    replay.events.judgement.wrong_side_s = 0.125;
    replay.events.judgement.unavailable_s = 1.5;
    replay.largest_load_transfer_ratio = 0.99;
    replay.confirmed_codes = three_cycles().confirmed_codes;
    const std::vector<sil::ReplayRow> rows{sil::replay_row("a,b/x.csv", "x", replay),
                                           sil::failed_row("y.csv", "y")};
    const std::string csv = sil::table_csv(rows);
    EXPECT_EQ(csv,
              "file,drive,warning_time_s,one_wheel_lift_time_s,two_wheel_lift_time_s,lead_time_s,"
              "wrong_side_duration_s,unavailable_duration_s,largest_load_transfer_ratio,"
              "largest_warning_level,verdict,confirmed_codes,warnings\n"
              "\"a,b/x.csv\",x,1.000,1.100,1.200,0.250,0.125,1.500,0.9900,,ahead,speed stuck,\n"
              "y.csv,y,,,,,,,,,failed,,\n");
    EXPECT_THAT(sil::table_text(rows), testing::HasSubstr("  1.50    0.990        -  ahead (speed stuck)\n"));
    EXPECT_THAT(sil::table_text(rows), testing::HasSubstr("2 drives: 1 ahead, 1 failed"));
}

TEST(ReplayTable, SaysWhichDrivesShowThatTheRollAngleIsNotWhatTheCalibrationSays) {
    sil::DriveReplay replay = lifted(WarningSide::right, 0.25);
    const sil::ReplayRow good = sil::replay_row("x.csv", "x", replay);
    EXPECT_THAT(sil::table_text({good}), testing::Not(testing::HasSubstr("roll_angle_reference")));
    replay.confirmed_codes = std::uint64_t{1U} << static_cast<unsigned>(
                                 rsi::can_dbc::RolloverDiagnosis::Code::roll_angle_reference_wrong);
    EXPECT_THAT(
        sil::table_text({good, sil::replay_row("y.csv", "y", replay), sil::replay_row("z.csv", "z", replay)}),
        testing::HasSubstr("\ny, z: on banked road the roll angle is not what roll_angle_reference "
                           "says"));
}

TEST(ReplayTable, ItsColumnsStandBelowTheirNames) {
    std::istringstream lines{
        sil::table_text({sil::replay_row("x.csv", "a-longer-name", lifted(WarningSide::right, 0.5))})};
    std::string header;
    std::string row;
    std::getline(lines, header);
    std::getline(lines, row);
    EXPECT_EQ(header.find("verdict"), row.find("ahead"));
    EXPECT_EQ(header.find("lead s") + 6U, row.find("0.50") + 4U);
}

}  // namespace
