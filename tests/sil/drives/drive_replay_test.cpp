// Drive replay: the firmware must say of a recorded drive what it said during the drive.
#include "sil/studies/drives/drive_replay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "sil/studies/drives/drive_csv.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "tests/sil/drives/recorded_drive.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using testing_drives::changes;
using testing_drives::large_suv_calibration;
using testing_drives::record_drive;
using testing_drives::RecordedDrive;

std::vector<sil::EcuOutput> ecu_outputs(const sil::DriveReplay& replay) {
    std::vector<sil::EcuOutput> outputs;
    for (const sil::ReplayCycle& cycle : replay.cycles) {
        outputs.push_back(cycle.ecu);
    }
    return outputs;
}

// A run of the hard turn with noise, its two records read back.
class HardTurn : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        const test_support::ScratchFolder folder;
        run = std::make_unique<RecordedDrive>(record_drive(testing_drives::hard_turn(), 5.0, folder.path()));
        drive = std::make_unique<sil::Drive>(sil::read_drive_csv(folder.path() / "signals.csv"));
        log = std::make_unique<std::vector<sil::LoggedFrame>>(
            sil::read_candump_log(folder.path() / "candump.log"));
    }
    static void TearDownTestSuite() {
        run.reset();
        drive.reset();
        log.reset();
    }

    static sil::Drive without(const std::function<void(sil::DriveSample&)>& remove) {
        sil::Drive result = *drive;
        std::for_each(result.samples.begin(), result.samples.end(), remove);
        return result;
    }

    static std::unique_ptr<RecordedDrive> run;
    static std::unique_ptr<sil::Drive> drive;
    static std::unique_ptr<std::vector<sil::LoggedFrame>> log;
};

std::unique_ptr<RecordedDrive> HardTurn::run;
std::unique_ptr<sil::Drive> HardTurn::drive;
std::unique_ptr<std::vector<sil::LoggedFrame>> HardTurn::log;

TEST_F(HardTurn, SignalsOfTheRunGiveTheWarningsOfTheRun) {
    ASSERT_TRUE(run->events.warning && run->events.two_wheel_lift);  // else the test would show nothing
    const sil::DriveReplay replay = sil::replay_drive(*drive, large_suv_calibration());
    EXPECT_EQ(changes(ecu_outputs(replay)), changes(run->ecu_outputs));
    EXPECT_NEAR(replay.events.warning->time_s, run->events.warning->time_s, 1e-9);
    EXPECT_EQ(replay.events.warning_side, run->events.warning_side);
    EXPECT_EQ(replay.silent_cycles, 0U);
    EXPECT_EQ(replay.frames_sent, 3U * replay.cycles.size());
}

TEST_F(HardTurn, ColumnsOfARunAreNotCalledIgnored) {
    EXPECT_THAT(drive->ignored_columns, testing::IsEmpty());
}

// A run calls a wheel lifted when it carries nothing, a replay below 1 %: a little earlier, but a row later
// at most.
TEST_F(HardTurn, LiftOffAndLeadAreNearlyThoseOfTheRun) {
    const auto expect_near = [](double actual_s, double expected_s) {
        EXPECT_LE(actual_s, expected_s + 0.0101);
        EXPECT_GE(actual_s, expected_s - 0.04);
    };
    const sil::DriveReplay replay = sil::replay_drive(*drive, large_suv_calibration());
    EXPECT_EQ(replay.lift_off.source, sil::LiftOffSource::wheel_loads);
    expect_near(replay.events.one_wheel_lift.value().time_s, run->events.one_wheel_lift.value().time_s);
    expect_near(replay.events.two_wheel_lift.value().time_s, run->events.two_wheel_lift.value().time_s);
    expect_near(replay.events.judgement.lead_s.value(), run->events.judgement.lead_s.value());
    EXPECT_EQ(replay.events.judgement.falling_side, run->events.judgement.falling_side);
    EXPECT_NEAR(replay.events.judgement.wrong_side_s, run->events.judgement.wrong_side_s, 0.0101);
    EXPECT_GT(replay.largest_load_transfer_ratio, 0.95);
}

TEST_F(HardTurn, TheLogOfTheRunGivesTheWarningsOfTheRun) {
    const sil::DriveReplay replay = sil::replay_drive(*log, large_suv_calibration());
    EXPECT_EQ(changes(ecu_outputs(replay)), changes(run->ecu_outputs));
    EXPECT_EQ(replay.lift_off.source, sil::LiftOffSource::unknown);
}

TEST_F(HardTurn, LogAndSignalsGiveTheSameIndices) {
    const sil::DriveReplay of_log = sil::replay_drive(*log, large_suv_calibration());
    const sil::DriveReplay of_signals = sil::replay_drive(*drive, large_suv_calibration());
    ASSERT_LE(of_log.cycles.size(), of_signals.cycles.size());
    ASSERT_GE(of_log.cycles.size() + 1U, of_signals.cycles.size());
    for (std::size_t index = 0U; index < of_log.cycles.size(); ++index) {
        const sil::ReplayCycle& a = of_log.cycles[index];
        const sil::ReplayCycle& b = of_signals.cycles[index];
        EXPECT_NEAR(a.sample.time_s, b.sample.time_s, 1e-6);
        // The log holds what became of the samples on the bus: half a step of the frames (0.01 deg/s, 0.002
        // m/s^2).
        EXPECT_NEAR(a.sample.roll_rate_radps, b.sample.roll_rate_radps, 0.00501 / 57.29);
        EXPECT_NEAR(a.sample.lateral_acceleration_mps2, b.sample.lateral_acceleration_mps2, 0.00101);
        EXPECT_NEAR(a.outputs.rsi_bank_free, b.outputs.rsi_bank_free, 1e-3F) << index;
    }
}

TEST_F(HardTurn, TheSameDriveGivesTheSameAnswerTwice) {
    const sil::DriveReplay first = sil::replay_drive(*drive, large_suv_calibration());
    const sil::DriveReplay second = sil::replay_drive(*drive, large_suv_calibration());
    ASSERT_EQ(first.cycles.size(), second.cycles.size());
    for (std::size_t index = 0U; index < first.cycles.size(); ++index) {
        EXPECT_EQ(first.cycles[index].outputs.roll_centre_vertical_m,
                  second.cycles[index].outputs.roll_centre_vertical_m);
    }
}

TEST_F(HardTurn, WithoutWhatIsOptionalThereIsStillAWarning) {
    const sil::Drive bare = without([](sil::DriveSample& sample) {
        sil::DriveSample kept;
        kept.time_s = sample.time_s;
        kept.lateral_acceleration_mps2 = sample.lateral_acceleration_mps2;
        kept.roll_rate_radps = sample.roll_rate_radps;
        kept.roll_angle_rad = sample.roll_angle_rad;
        sample = kept;
    });
    const sil::DriveReplay replay = sil::replay_drive(bare, large_suv_calibration());
    ASSERT_TRUE(replay.events.warning);
    EXPECT_NEAR(replay.events.warning->time_s, run->events.warning->time_s, 0.15);
    EXPECT_EQ(replay.lift_off.source, sil::LiftOffSource::unknown);
    EXPECT_TRUE(std::isnan(replay.largest_load_transfer_ratio));
    EXPECT_FALSE(replay.events.judgement.lead_s);
}

// A roll angle that never comes must be known to be missing before the firmware is ready without it.
TEST_F(HardTurn, WithoutARollAngleTheStartUpIsLongerAndIsNotUnavailable) {
    const sil::Drive bare =
        without([](sil::DriveSample& sample) { sample.roll_angle_rad = sil::DriveSample::not_available; });
    const sil::DriveReplay replay = sil::replay_drive(bare, large_suv_calibration());
    EXPECT_EQ(replay.cycles[20].ecu.state(), sil::WarningState::unavailable);
    EXPECT_EQ(replay.cycles[30].ecu.state(), sil::WarningState::ready);
    EXPECT_EQ(replay.events.judgement.unavailable_s, 0.0);
}

TEST_F(HardTurn, TimeNeedNotBeginAtZero) {
    const sil::Drive later = without([](sil::DriveSample& sample) { sample.time_s += 1.7e9; });
    const sil::DriveReplay replay = sil::replay_drive(later, large_suv_calibration());
    EXPECT_EQ(changes(ecu_outputs(replay)), changes(run->ecu_outputs));
    EXPECT_NEAR(replay.events.warning->time_s - 1.7e9, run->events.warning->time_s, 1e-5);
}

TEST_F(HardTurn, AGapIsSilenceForTheFirmware) {
    sil::Drive gap = *drive;
    gap.samples.erase(gap.samples.begin() + 30, gap.samples.begin() + 45);  // 0.30 to 0.44 s
    const sil::DriveReplay replay = sil::replay_drive(gap, large_suv_calibration());
    EXPECT_EQ(replay.silent_cycles, 15U);
    EXPECT_EQ(replay.cycles.size(), run->ecu_outputs.size());
    EXPECT_EQ(replay.cycles[29].ecu.state(), sil::WarningState::ready);
    EXPECT_EQ(replay.cycles[44].ecu.state(), sil::WarningState::unavailable);
}

TEST_F(HardTurn, TellsCodesDegradationAndUnavailableTime) {
    sil::Drive gap = *drive;
    gap.samples.erase(gap.samples.begin() + 30, gap.samples.begin() + 45);  // 0.30 to 0.44 s
    const sil::DriveReplay replay = sil::replay_drive(gap, large_suv_calibration());
    const auto unavailable = std::count_if(
        replay.cycles.begin() + 21, replay.cycles.end(),
        [](const sil::ReplayCycle& cycle) { return cycle.ecu.state() == sil::WarningState::unavailable; });
    EXPECT_GT(unavailable, 10);
    EXPECT_NEAR(replay.events.judgement.unavailable_s, 0.01 * static_cast<double>(unavailable), 1e-9);
    EXPECT_EQ(sil::code_names(replay.cycles[29].codes.set), "");
    EXPECT_THAT(sil::code_names(replay.cycles[44].codes.confirmed), testing::HasSubstr("imu lost"));
    EXPECT_THAT(sil::code_names(replay.confirmed_codes), testing::HasSubstr("imu lost"));
    const auto degradation = [&](std::size_t cycle) {
        return replay.cycles[cycle].ecu.of<rsi::can_dbc::RolloverDiagnosis>().degradation;
    };
    EXPECT_EQ(degradation(29U), rsi::can_dbc::RolloverDiagnosis::Degradation::full);
    EXPECT_EQ(degradation(44U), rsi::can_dbc::RolloverDiagnosis::Degradation::unavailable);
    // Frames that come again heal the code.
    EXPECT_EQ(sil::code_names(replay.cycles[99].codes.confirmed).find("imu lost"), std::string::npos);
    const sil::DriveReplay whole = sil::replay_drive(*drive, large_suv_calibration());
    EXPECT_EQ(whole.confirmed_codes, 0U);
    EXPECT_EQ(whole.events.judgement.unavailable_s, 0.0);
}

// One sample is too little to confirm anything, and what was only set is forgotten.
TEST_F(HardTurn, ACodeMayBeSetWithoutBeingConfirmed) {
    sil::Drive spike = *drive;
    spike.samples[50].roll_rate_radps += 3.0;
    const sil::DriveReplay replay = sil::replay_drive(spike, large_suv_calibration());
    EXPECT_EQ(replay.cycles[49].codes.set, 0U);
    EXPECT_THAT(sil::code_names(replay.cycles[51].codes.set), testing::HasSubstr("roll rate jump"));
    EXPECT_EQ(sil::code_names(replay.cycles[99].codes.set), "");
    EXPECT_EQ(replay.confirmed_codes, 0U);
}

// Without noise, which a denser drive would average.
TEST(Replay, OfADriveAt200HzWarnsWithinOneCycle) {
    const test_support::ScratchFolder folder;
    const RecordedDrive run = record_drive(testing_drives::hard_turn(), 5.0, folder.path(), false);
    const sil::Drive drive = sil::read_drive_csv(folder.path() / "signals.csv");
    sil::Drive dense = drive;
    dense.samples.clear();
    const auto half_way = [](double a, double b) { return 0.5 * (a + b); };
    for (std::size_t index = 0U; index + 1U < drive.samples.size(); ++index) {
        const sil::DriveSample& a = drive.samples[index];
        const sil::DriveSample& b = drive.samples[index + 1U];
        sil::DriveSample middle = a;
        middle.time_s = half_way(a.time_s, b.time_s);
        middle.lateral_acceleration_mps2 = half_way(a.lateral_acceleration_mps2, b.lateral_acceleration_mps2);
        middle.vertical_acceleration_mps2 =
            half_way(a.vertical_acceleration_mps2, b.vertical_acceleration_mps2);
        middle.roll_rate_radps = half_way(a.roll_rate_radps, b.roll_rate_radps);
        middle.roll_angle_rad = half_way(a.roll_angle_rad, b.roll_angle_rad);
        dense.samples.push_back(a);
        dense.samples.push_back(middle);
    }
    const sil::DriveReplay replay = sil::replay_drive(dense, large_suv_calibration());
    EXPECT_NEAR(replay.events.warning.value().time_s, run.events.warning.value().time_s, 0.0101);
}

TEST_F(HardTurn, AnInterruptedReplayGivesNoResult) {
    int cycles = 0;
    EXPECT_THROW(
        static_cast<void>(sil::replay_drive(*drive, large_suv_calibration(), [&] { return ++cycles > 10; })),
        sil::ReplayInterrupted);
    EXPECT_EQ(cycles, 11);
}

TEST_F(HardTurn, GivenLiftOffWinsAndDecidesTheLead) {
    sil::Drive given = *drive;
    given.lift_off_given = true;
    given.two_wheel_lift_s = run->events.warning->time_s + 0.25;
    const sil::DriveReplay replay = sil::replay_drive(given, large_suv_calibration());
    EXPECT_NEAR(replay.events.judgement.lead_s.value(), 0.25, 1e-9);
}

// Without wheel loads the measured turn says to which side the vehicle falls.
TEST_F(HardTurn, OfAGivenLiftOffWithoutLoadsTheTurnTellsTheSide) {
    sil::Drive given =
        without([](sil::DriveSample& sample) { sample.wheel_load_n.fill(sil::DriveSample::not_available); });
    given.lift_off_given = true;
    given.two_wheel_lift_s = run->events.two_wheel_lift->time_s;
    const sil::DriveReplay replay = sil::replay_drive(given, large_suv_calibration());
    EXPECT_EQ(replay.events.judgement.falling_side, sil::WarningSide::right);
    EXPECT_NEAR(replay.events.judgement.lead_s.value(), run->events.judgement.lead_s.value(), 1e-9);
}

TEST(Replay, OfALogWithoutSensorFramesIsRefused) {
    EXPECT_ANY_THROW(
        static_cast<void>(sil::replay_drive(std::vector<sil::LoggedFrame>{}, large_suv_calibration())));
}

// Straight ahead on a road of 8 % bank, left side up: the body's accelerometer shows gravity's share, which
// the component takes off when a column tells the bank, and takes for lateral acceleration when none does.
TEST(Replay, OfAVehicleOnABankUsesTheBank) {
    const double bank_rad = std::atan(0.08);
    sil::Manoeuvre manoeuvre = sil::find_manoeuvre("straight");
    manoeuvre.make_road = [bank_rad](std::uint64_t) { return std::make_unique<sil::PlaneRoad>(bank_rad); };
    const test_support::ScratchFolder folder;
    const RecordedDrive run = record_drive(manoeuvre, 2.0, folder.path());
    const sil::Drive blind = sil::read_drive_csv(folder.path() / "signals.csv");
    sil::Drive told = blind;
    for (sil::DriveSample& sample : told.samples) {
        sample.bank_angle_rad = bank_rad;
    }
    const sil::DriveReplay of_blind = sil::replay_drive(blind, large_suv_calibration());
    const sil::DriveReplay of_reported = sil::replay_drive(told, large_suv_calibration());
    EXPECT_EQ(changes(ecu_outputs(of_blind)), changes(run.ecu_outputs));
    EXPECT_FALSE(of_reported.events.warning);
    double sum_reported = 0.0;
    double sum_blind = 0.0;
    for (std::size_t index = 101U; index <= 200U; ++index) {
        sum_reported +=
            static_cast<double>(of_reported.cycles[index].outputs.lateral_acceleration_mps2) / 100.0;
        sum_blind += static_cast<double>(of_blind.cycles[index].outputs.lateral_acceleration_mps2) / 100.0;
    }
    // g sin b = 0.78 m/s^2. Noise and the car's slow drift down the slope are left.
    EXPECT_NEAR(std::fabs(sum_reported - sum_blind), 9.80665 * std::sin(bank_rad), 0.1);
    EXPECT_NEAR(sum_reported, 0.0, 0.3);
}

}  // namespace
