// A body that obeys the roll equation gives its parameters back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sil/studies/identification/identification.hpp"
#include "sil/studies/identification/lift_cut.hpp"
#include "sil/studies/identification/report.hpp"
#include "tests/sil/identification/known_body.hpp"

namespace {

using identification_test::KnownBody;
using identification_test::Recording;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

sil::Identification identified(const KnownBody& body, const sil::VehicleData& data,
                               const Recording& recording = {},
                               const sil::IdentificationOptions& options = {}) {
    return sil::identify(data, {identification_test::ramp_of(body, 5.5, recording)},
                         {identification_test::steps_of(body, recording)}, options);
}

void expect_body(const KnownBody& body, const sil::Identification& result, double share) {
    for (const double phi : {0.01, 0.03, 0.05, 0.07}) {
        EXPECT_NEAR(result.roll.moment_nm(phi), body.moment_nm(phi), share * body.moment_nm(phi)) << phi;
    }
    EXPECT_NEAR(result.roll.damping_nmsprad.value, body.damping_nmsprad, share * body.damping_nmsprad);
    EXPECT_NEAR(result.roll.inertia_kgm2.value, body.inertia_kgm2, share * body.inertia_kgm2);
}

TEST(KnownBodyTest, GivesItsParametersBackWithinOnePerCent) {
    const KnownBody body;
    const sil::Identification result = identified(body, identification_test::data_sheet_of(body));
    expect_body(body, result, 0.01);
    EXPECT_NEAR(result.roll_centre_height_m, body.roll_centre_height_m, 0.005);
    ASSERT_TRUE(result.steering);
    EXPECT_NEAR(result.steering->understeer_gradient_s2pm.value, body.understeer_gradient_s2pm,
                0.01 * body.understeer_gradient_s2pm);
}

TEST(KnownBodyTest, GivesThemBackWhereverTheImuSits) {
    KnownBody body;
    body.imu_x_m = -1.0;
    body.imu_y_m = -0.4;
    body.imu_z_m = 0.5;
    expect_body(body, identified(body, identification_test::data_sheet_of(body)), 0.01);
}

// 0.03 g, 1 deg and 0.5 deg/s are what cheap sensors have before they are zeroed.
TEST(KnownBodyTest, GivesThemBackInSpiteOfSensorOffsets) {
    const KnownBody body;
    Recording recording;
    recording.lateral_offset_mps2 = 0.3;
    recording.roll_offset_rad = 0.017;
    recording.roll_rate_offset_radps = 0.009;
    const sil::Identification result = identified(body, identification_test::data_sheet_of(body), recording);
    expect_body(body, result, 0.015);
    EXPECT_NEAR(result.ramps.front().offsets.lateral_mps2, 0.3, 0.005);
    EXPECT_NEAR(result.ramps.front().offsets.roll_angle_rad, 0.017, 0.0005);
    EXPECT_THAT(result.warnings, Contains(HasSubstr("zero the sensors")));
}

// Turns can be recognised by the lateral acceleration alone.
TEST(KnownBodyTest, FindsTheSensorOffsetsWithoutSteeringSpeedAndYawRate) {
    const KnownBody body;
    Recording recording;
    recording.lateral_offset_mps2 = 0.3;
    recording.roll_offset_rad = 0.017;
    recording.roll_rate_offset_radps = 0.009;
    recording.steering = false;
    recording.motion = false;
    sil::VehicleData data = identification_test::data_sheet_of(body);
    data.imu_x_m = data.imu_y_m = 0.0;
    KnownBody central = body;
    central.imu_x_m = central.imu_y_m = 0.0;
    const sil::Identification result = identified(central, data, recording);
    expect_body(body, result, 0.03);
    for (const auto* drives : {&result.ramps, &result.dynamics}) {
        const sil::SensorOffsets& offsets = drives->front().offsets;
        EXPECT_TRUE(offsets.known);
        EXPECT_NEAR(offsets.lateral_mps2, 0.3, 0.06);
        EXPECT_NEAR(offsets.roll_rate_radps, 0.009, 0.001);
    }
    EXPECT_THAT(result.warnings, Not(Contains(HasSubstr("does not start with"))));
}

TEST(KnownBodyTest, WithoutMotionADriveThatStartsInATurnHasNoStraight) {
    Recording recording;
    recording.steering = false;
    recording.motion = false;
    const sil::Drive turn =
        identification_test::drive_of(KnownBody{}, 6.0, [](double) { return 3.0; }, recording);
    const sil::PreparedDrive drive = sil::prepare_drive(turn, identification_test::data_sheet_of({}), {});
    EXPECT_FALSE(drive.offsets.known);
    EXPECT_EQ(drive.offsets.judged_by, "lateral acceleration");
}

TEST(KnownBodyTest, WithoutWheelLoadsGivesTheRatiosToTheArmAndSaysSo) {
    const KnownBody body;
    Recording recording;
    recording.wheel_loads = false;
    const sil::Identification result = identified(body, identification_test::data_sheet_of(body), recording);
    const double true_arm_m = body.sprung_cg_height_m - body.roll_centre_height_m;
    EXPECT_NEAR(result.roll.stiffness_nmprad.value / result.roll.arm_m, body.stiffness_nmprad / true_arm_m,
                0.01 * body.stiffness_nmprad / true_arm_m);
    EXPECT_NEAR(result.roll.inertia_kgm2.value / result.roll.arm_m, body.inertia_kgm2 / true_arm_m,
                0.01 * body.inertia_kgm2 / true_arm_m);
    EXPECT_THAT(result.warnings, Contains(HasSubstr("gives only K/H, c/H and Ixx/H")));
}

TEST(KnownBodyTest, WithoutWheelLoadsTakesTheRollCentreThatIsGiven) {
    const KnownBody body;
    sil::VehicleData data = identification_test::data_sheet_of(body);
    data.roll_centre_height_m = body.roll_centre_height_m;
    Recording recording;
    recording.wheel_loads = false;
    const sil::Identification result = identified(body, data, recording);
    expect_body(body, result, 0.01);
    EXPECT_THAT(result.warnings, Not(Contains(HasSubstr("gives only K/H"))));
}

TEST(KnownBodyTest, WithoutWheelLoadsUsesNothingAbove85PerCentOfTheStaticStability) {
    const KnownBody body;
    Recording recording;
    recording.wheel_loads = false;
    const sil::VehicleData data = identification_test::data_sheet_of(body);
    const sil::PreparedDrive drive = sil::prepare_drive(identification_test::ramp_of(body, 9.5, recording),
                                                        data, sil::PreparationOptions{});
    const double limit_mps2 = 0.85 * 9.80665 * body.track_width_m / (2.0 * body.sprung_cg_height_m);
    EXPECT_LT(drive.largest_parallel_mps2, limit_mps2);
    EXPECT_GT(drive.largest_parallel_mps2, 0.97 * limit_mps2);
    EXPECT_THAT(drive.cut_reason, HasSubstr("a first wheel may have lifted before"));
}

TEST(KnownBodyTest, TheHeightsAndForcesGiveTheLoadTransferOfTheWheels) {
    const KnownBody body;
    sil::VehicleData data = identification_test::data_sheet_of(body);
    data.roll_inertia_kgm2 = body.inertia_kgm2;
    for (const sil::Drive& each :
         {identification_test::ramp_of(body, 5.5), identification_test::steps_of(body)}) {
        const sil::PreparedDrive drive = sil::prepare_drive(each, data, {});
        double largest = 0.0;
        for (const sil::RollSample& sample : drive.samples) {
            const double measured = std::abs(sample.load_moment_nm) /
                                    (0.5 * data.total_mass_kg * sample.normal_mps2 * data.track_width_m);
            const double expected = sil::load_transfer_by_heights(data, sample);
            EXPECT_NEAR(expected, measured, 0.03) << each.name << " at " << sample.time_s;
            largest = std::max(largest, measured);
        }
        EXPECT_GT(largest, 0.25);
    }
}

TEST(KnownBodyTest, UsesNothingAfterAWheelHasLifted) {
    const KnownBody body;
    sil::Drive ramp = identification_test::ramp_of(body, 5.5);
    for (sil::DriveSample& sample : ramp.samples) {
        if (sample.time_s >= 12.0) {
            sample.wheel_load_n[sil::rear_left] = 0.0;
        }
    }
    const sil::PreparedDrive drive = sil::prepare_drive(ramp, identification_test::data_sheet_of(body), {});
    EXPECT_LT(drive.samples.back().time_s, 12.0);
    EXPECT_GT(drive.samples.back().time_s, 11.9);
}

TEST(KnownBodyTest, FitsTheSteeringRatioWhenTheUndersteerGradientIsGiven) {
    const KnownBody body;
    sil::VehicleData data = identification_test::data_sheet_of(body);
    data.steering_ratio.reset();
    data.understeer_gradient_s2pm = body.understeer_gradient_s2pm;
    const sil::Identification result = identified(body, data);
    ASSERT_TRUE(result.steering);
    EXPECT_NEAR(result.steering->ratio.value, body.steering_ratio, 0.01 * body.steering_ratio);
}

TEST(KnownBodyTest, FitsRatioAndGradientFromRampsAtTwoSpeeds) {
    KnownBody slow, fast;
    slow.speed_mps = 14.0;
    fast.speed_mps = 25.0;
    sil::VehicleData data = identification_test::data_sheet_of(slow);
    data.steering_ratio.reset();
    const sil::Identification result = sil::identify(
        data, {identification_test::ramp_of(slow, 5.5), identification_test::ramp_of(fast, 5.5)},
        {identification_test::steps_of(slow)});
    ASSERT_TRUE(result.steering);
    EXPECT_NEAR(result.steering->ratio.value, slow.steering_ratio, 0.02 * slow.steering_ratio);
    EXPECT_NEAR(result.steering->understeer_gradient_s2pm.value, slow.understeer_gradient_s2pm,
                0.03 * slow.understeer_gradient_s2pm);
}

TEST(KnownBodyTest, AShortRampGivesALineAndAWarning) {
    KnownBody body;
    body.stiffness_cubic_nmprad3 = 0.0;
    const sil::Identification result =
        sil::identify(identification_test::data_sheet_of(body), {identification_test::ramp_of(body, 2.5)},
                      {identification_test::steps_of(body)});
    EXPECT_NEAR(result.roll.moment_nm(0.12), body.moment_nm(0.12), 0.1 * body.moment_nm(0.12));
    EXPECT_THAT(result.warnings, Contains(HasSubstr("the ramp reaches only 0.25 g")));
}

// A curve that bends down would let the body fall over on its springs.
TEST(KnownBodyTest, TheFittedCurveRisesUpToRollover) {
    KnownBody body;
    body.stiffness_nmprad = 120.0e3;
    body.stiffness_cubic_nmprad3 = -7.0e6;
    const sil::Identification result = identified(body, identification_test::data_sheet_of(body));
    const double limit_rad = sil::rollover_angle_rad(result.vehicle, result.roll);
    for (double phi = 0.0; phi < limit_rad; phi += 0.002) {
        EXPECT_GT(result.roll.slope_nmprad(phi), 0.0) << phi;
    }
}

// Load transfer of the wheels over the component's, in the slow turn.
double seen_ratio(const sil::Identification& result) {
    const sil::RollSample& sample = result.ramps.front().samples[1500];
    return sample.load_moment_nm / sil::component_load_moment_nm(result.vehicle, result.roll, sample);
}

// Tyres that give way sideways move the CG out with the force, as a higher CG would.
// A load that sways does so still more: 10 %.
TEST(KnownBodyTest, MatchesTheCgHeightWhenTheWheelLoadsAskForAnImpossibleRollCentre) {
    for (const double share : {0.96, 0.9}) {
        const KnownBody body;
        sil::VehicleData data = identification_test::data_sheet_of(body);
        data.sprung_cg_height_m = share * body.sprung_cg_height_m;
        const sil::Identification result = identified(body, data);
        EXPECT_LT(result.loads->roll_centre_at_given_height_m, 0.0) << share;
        EXPECT_GT(result.vehicle.sprung_cg_height_m, data.sprung_cg_height_m);
        EXPECT_GE(result.roll_centre_height_m, 0.0);
        for (const sil::DriveResidual& drive : result.load_transfer) {
            EXPECT_LT(drive.rms, 0.02) << drive.name;
        }
        EXPECT_NEAR(seen_ratio(result), 1.0, 0.01) << share;
        EXPECT_THAT(result.warnings, Not(Contains(HasSubstr("late and missed warnings")))) << share;
        EXPECT_THAT(result.warnings, Contains(HasSubstr("which together give the wheel loads"))) << share;
    }
}

// The CG height stands for it even if the roll centre does lie there.
TEST(KnownBodyTest, HonoursTheLoadTransferOfARollCentreBelowTheRoad) {
    KnownBody body;
    body.stiffness_nmprad = 150.0e3;
    body.roll_centre_height_m = -0.3;
    const sil::Identification result = identified(body, identification_test::data_sheet_of(body));
    EXPECT_NEAR(result.loads->roll_centre_at_given_height_m, body.roll_centre_height_m, 0.01);
    EXPECT_NEAR(seen_ratio(result), 1.0, 0.01);
    sil::IdentificationOptions options;
    options.keep_cg_height = true;
    EXPECT_GT(seen_ratio(identified(body, identification_test::data_sheet_of(body), {}, options)), 1.02);
}

// Exactly on the road, as the fit gives it but for rounding, is a place where a suspension has it.
TEST(KnownBodyTest, ARollCentreOnTheRoadIsPlausibleWithinRounding) {
    for (const double height_m : {-0.003, -1.0e-6, 0.0, 0.003}) {
        KnownBody body;
        body.roll_centre_height_m = height_m;
        const sil::Identification result = identified(body, identification_test::data_sheet_of(body));
        EXPECT_DOUBLE_EQ(result.vehicle.sprung_cg_height_m, body.sprung_cg_height_m) << height_m;
        EXPECT_THAT(result.warnings, Not(Contains(HasSubstr("where no suspension has it")))) << height_m;
        EXPECT_THAT(result.warnings, Not(Contains(HasSubstr("-0.00 ")))) << height_m;
        EXPECT_THAT(sil::identification_report(result), Not(HasSubstr("h_rc -0.000"))) << height_m;
    }
}

// The user has measured it; what the loads ask for is said.
TEST(KnownBodyTest, KeepsTheCgHeightWhenAskedTo) {
    const KnownBody body;
    sil::VehicleData data = identification_test::data_sheet_of(body);
    data.sprung_cg_height_m = 0.96 * body.sprung_cg_height_m;
    sil::IdentificationOptions options;
    options.keep_cg_height = true;
    const sil::Identification result = identified(body, data, {}, options);
    EXPECT_DOUBLE_EQ(result.vehicle.sprung_cg_height_m, data.sprung_cg_height_m);
    EXPECT_DOUBLE_EQ(result.roll_centre_height_m, 0.0);
    EXPECT_THAT(result.warnings, Contains(HasSubstr("leave --keep-cg-height out")));
    EXPECT_THAT(result.warnings, Contains(HasSubstr("late and missed warnings")));
    EXPECT_EQ(result.cg_height_origin, "vehicle data");
}

// A bus with rigid axles: its roll centre is its roll centre, and no height need be fitted.
KnownBody bus(double roll_centre_height_m) {
    KnownBody body;
    body.sprung_cg_height_m = 1.9;
    body.roll_centre_height_m = roll_centre_height_m;
    body.track_width_m = 2.4;
    return body;
}

TEST(KnownBodyTest, FindsTheRollCentreOfRigidAxles) {
    for (const double height_m : {0.6, 0.9, 1.19}) {
        const KnownBody body = bus(height_m);
        const sil::Identification result = identified(body, identification_test::data_sheet_of(body));
        EXPECT_NEAR(result.roll_centre_height_m, height_m, 0.005);
        EXPECT_DOUBLE_EQ(result.vehicle.sprung_cg_height_m, body.sprung_cg_height_m);
    }
    const KnownBody too_high = bus(1.23);
    EXPECT_DOUBLE_EQ(identified(too_high, identification_test::data_sheet_of(too_high)).roll_centre_height_m,
                     1.2);
}

TEST(KnownBodyTest, TheRollCentreStaysBelowSevenTenthsOfTheCgHeight) {
    KnownBody body;
    body.roll_centre_height_m = 0.68 * body.sprung_cg_height_m;
    EXPECT_NEAR(identified(body, identification_test::data_sheet_of(body)).roll_centre_height_m,
                body.roll_centre_height_m, 0.003);
    body.roll_centre_height_m = 0.72 * body.sprung_cg_height_m;
    EXPECT_NEAR(identified(body, identification_test::data_sheet_of(body)).roll_centre_height_m,
                0.7 * body.sprung_cg_height_m, 1e-9);
}

TEST(KnownBodyTest, WithoutWheelLoadsNoRollCentreAboveTheRoadIsMissedAndTheCostIsSaid) {
    const KnownBody body;
    Recording recording;
    recording.wheel_loads = false;
    const sil::VehicleData data = identification_test::data_sheet_of(body);
    const sil::Identification result = identified(body, data, recording);
    EXPECT_DOUBLE_EQ(result.roll_centre_height_m, 0.0);
    EXPECT_THAT(result.warnings, Contains(HasSubstr("It costs early warnings")));
    EXPECT_THAT(result.warnings, Contains(HasSubstr("as long as the roll centre lies on or above it")));
    const auto moment_nm = [&](double height_m) {
        sil::VehicleData given = data;
        given.roll_centre_height_m = height_m;
        const sil::Identification other = identified(body, given, recording);
        return sil::component_load_moment_nm(given, other.roll, other.ramps.front().samples[1200]);
    };
    const double taken_nm =
        sil::component_load_moment_nm(data, result.roll, result.ramps.front().samples[1200]);
    // In a slow turn no roll centre on or above the road gives more load transfer; one below it does.
    for (const double height_m : {0.0, 0.2, 0.5}) {
        EXPECT_LE(moment_nm(height_m), 1.0001 * taken_nm) << height_m;
    }
    EXPECT_GT(moment_nm(-0.1), 1.005 * taken_nm);
}

// 2 deg of roll say nothing about 6 deg.
TEST(KnownBodyTest, TheCurveStaysPlausibleBeyondTheData) {
    KnownBody body;
    body.stiffness_cubic_nmprad3 = 1.2e7;
    const sil::VehicleData data = identification_test::data_sheet_of(body);
    const sil::Identification result =
        sil::identify(data, {identification_test::ramp_of(body, 3.2)}, {identification_test::steps_of(body)});
    EXPECT_THAT(result.warnings, Contains(HasSubstr("slope is held")));
    const double at_end = result.roll.slope_nmprad(result.roll.data_end_rad);
    const double lift_rad = sil::rollover_angle_rad(data, result.roll);
    EXPECT_LT(result.roll.data_end_rad, 0.5 * lift_rad);
    EXPECT_NEAR(result.roll.needed_up_to_rad, 1.2 * lift_rad, 0.001);
    for (double phi = result.roll.data_end_rad; phi < 1.2 * lift_rad; phi += 0.001) {
        EXPECT_GE(result.roll.slope_nmprad(phi), 0.5 * at_end) << phi;
        EXPECT_LE(result.roll.slope_nmprad(phi), 2.0 * at_end) << phi;
    }
}

// Springs go on straight where the data show no stop: 1.5 times the slope at the end of the data, and no less
// than two thirds of it, a little beyond the lift and half beyond the data.
TEST(KnownBodyTest, TheCurveGoesNearlyStraightBeyondDataWithoutAStop) {
    for (const double cubic : {0.0, 2.0e6, 3.0e6}) {
        KnownBody body;
        body.stiffness_cubic_nmprad3 = cubic;
        const sil::VehicleData data = identification_test::data_sheet_of(body);
        const sil::RollFit roll = sil::identify(data, {identification_test::ramp_of(body, 6.5)},
                                                {identification_test::steps_of(body)})
                                      .roll;
        const double at_end = roll.slope_nmprad(roll.data_end_rad);
        const double furthest_rad =
            std::max(1.5 * roll.data_end_rad, 1.2 * sil::rollover_angle_rad(data, roll));
        for (double phi = roll.data_end_rad; phi < furthest_rad; phi += 0.001) {
            EXPECT_GE(roll.slope_nmprad(phi), 0.66 * at_end) << cubic << " " << phi;
            EXPECT_LE(roll.slope_nmprad(phi), 1.51 * at_end) << cubic << " " << phi;
        }
        for (double phi = 0.005; phi < roll.data_end_rad; phi += 0.005) {
            EXPECT_NEAR(roll.moment_nm(phi), body.moment_nm(phi), 0.01 * body.moment_nm(phi)) << cubic;
        }
    }
}

// The lower the arm, the further the body leans before its wheels lift: the angle belongs to the arm that is
// used, not to the usual one of the rules of thumb.
TEST(KnownBodyTest, TheCurveStaysPlausibleUpToTheLiftWithTheArmThatIsUsed) {
    KnownBody body = bus(0.9);
    body.stiffness_nmprad = 150.0e3;
    body.stiffness_cubic_nmprad3 = 1.0e7;
    body.stiffness_quintic_nmprad5 = 1.0e9;
    body.damping_nmsprad = 15.0e3;
    const sil::VehicleData data = identification_test::data_sheet_of(body);
    const sil::Identification result =
        sil::identify(data, {identification_test::ramp_of(body, 3.0)}, {identification_test::steps_of(body)});
    EXPECT_NEAR(result.roll_centre_height_m, 0.9, 0.01);
    for (const sil::RollFit& roll :
         {result.roll, sil::fit_roll(data, {1.7, result.roll.arm_m}, result.ramps, result.dynamics)}) {
        const double needed_rad = 1.2 * sil::rollover_angle_rad(data, roll);
        EXPECT_NEAR(roll.needed_up_to_rad, needed_rad, 1e-6);
        const double at_end = roll.slope_nmprad(roll.data_end_rad);
        for (double phi = roll.data_end_rad; phi < needed_rad; phi += 0.001) {
            EXPECT_GE(roll.slope_nmprad(phi), 0.5 * at_end) << phi;
            EXPECT_LE(roll.slope_nmprad(phi), 2.0 * at_end) << phi;
        }
    }
}

// They are of absolute size, and without wheel loads only the ratios to the arm are known: then they take the
// usual arm, 0.2 m less than the CG height.
TEST(KnownBodyTest, TheRulesOfThumbTakeTheArmThatTheWheelLoadsGive) {
    const KnownBody body = bus(0.9);
    const sil::VehicleData data = identification_test::data_sheet_of(body);
    const double open_kgm2 = 0.4 * sil::usual_roll_inertia_kgm2(data);
    EXPECT_NEAR(identified(body, data).roll.inertia_kgm2.prior_deviation, open_kgm2, 1e-6 * open_kgm2);
    Recording recording;
    recording.wheel_loads = false;
    EXPECT_NEAR(identified(body, data, recording).roll.inertia_kgm2.prior_deviation, open_kgm2 * 1.9 / 1.7,
                1e-6 * open_kgm2);
}

TEST(KnownBodyTest, ACurveThatTheDataShowIsNotHeld) {
    const KnownBody body;
    EXPECT_THAT(identified(body, identification_test::data_sheet_of(body)).warnings,
                Not(Contains(HasSubstr("slope is held"))));
}

// The IMU sits above the CG and is said to sit below: what is missing of the force's moment goes into Ixx.
TEST(KnownBodyTest, TakesTheRuleOfThumbWhereTheDrivesGiveAnInertiaThatNoBodyHas) {
    KnownBody body;
    body.imu_z_m = 0.45;
    sil::VehicleData data = identification_test::data_sheet_of(body);
    data.imu_z_m = -0.45;
    const sil::Identification result = identified(body, data);
    ASSERT_TRUE(result.roll.refused_inertia_kgm2);
    EXPECT_LT(*result.roll.refused_inertia_kgm2, 0.0);
    const double usual_kgm2 = sil::usual_roll_inertia_kgm2(data);
    EXPECT_NEAR(result.value("roll_inertia_kgm2"), usual_kgm2, 0.02 * usual_kgm2);
    EXPECT_GT(result.roll.damping_nmsprad.value, 0.0);
    EXPECT_THAT(result.warnings, Contains(AllOf(HasSubstr("which no body has"), HasSubstr("imu_z_m"))));
    data.roll_inertia_kgm2 = 700.0;
    EXPECT_NEAR(identified(body, data).value("roll_inertia_kgm2"), 700.0, 0.2 * 700.0);
}

TEST(KnownBodyTest, WithoutWheelLoadsSaysInMetresWhichHeightsNothingChecks) {
    const KnownBody body;
    const sil::VehicleData data = identification_test::data_sheet_of(body);
    const auto are_unchecked = AllOf(HasSubstr("nothing checks these heights"), HasSubstr("0.850 m"),
                                     HasSubstr("0.043 m higher (5 %)"));
    Recording recording;
    recording.wheel_loads = false;
    EXPECT_THAT(identified(body, data, recording).warnings, Contains(are_unchecked));
    EXPECT_THAT(identified(body, data).warnings, Not(Contains(are_unchecked)));
    // The cost that it names is what the component then computes too little.
    sil::VehicleData higher = data;
    higher.sprung_cg_height_m *= 1.05;
    const auto moment_nm = [&](const sil::VehicleData& vehicle) {
        sil::VehicleData given = vehicle;
        given.roll_centre_height_m = 0.0;
        const sil::Identification result = identified(body, given, recording);
        return sil::component_load_moment_nm(given, result.roll, result.ramps.front().samples[1500]);
    };
    EXPECT_THAT(identified(body, data, recording).warnings,
                Contains(HasSubstr(fmt::format("there is {:.0f} % more load transfer",
                                               100.0 * (moment_nm(higher) / moment_nm(data) - 1.0)))));
}

// A CG height so wrong that no roll centre makes it agree with the wheel loads.
sil::Identification contradicted(double height_share) {
    KnownBody body;
    body.stiffness_cubic_nmprad3 = 0.0;
    sil::VehicleData data = identification_test::data_sheet_of(body);
    data.sprung_cg_height_m = height_share * body.sprung_cg_height_m;
    return identified(body, data);
}

std::string origin_of_roll_centre(const sil::Identification& result) {
    for (const sil::IdentifiedValue& value : result.values) {
        if (value.key == "fixed_roll_centre_height_m") {
            return value.origin;
        }
    }
    return {};
}

double said_ratio(const sil::Identification& result) {
    const std::string before = "load transfer ratio of ";
    for (const std::string& warning : result.warnings) {
        const std::size_t at = warning.find(before);
        if (at != std::string::npos) {
            return std::stod(warning.substr(at + before.size()));
        }
    }
    return std::nan("");
}

TEST(KnownBodyTest, TakesTheNearestRollCentreWhereCgHeightAndWheelLoadsContradictEachOther) {
    const sil::Identification low = contradicted(0.8);
    EXPECT_DOUBLE_EQ(low.roll_centre_height_m, 0.0);
    EXPECT_THAT(low.warnings, Contains(HasSubstr("It costs late and missed warnings")));
    EXPECT_GT(seen_ratio(low), 1.1);
    const sil::Identification high = contradicted(1.35);
    EXPECT_DOUBLE_EQ(high.roll_centre_height_m, 0.7 * high.given_cg_height_m);
    EXPECT_THAT(high.warnings, Contains(HasSubstr("It costs early warnings")));
    EXPECT_LT(seen_ratio(high), 0.95);
    for (const sil::Identification& result : {low, high}) {
        EXPECT_THAT(result.warnings, Contains(HasSubstr("contradict each other")));
        EXPECT_DOUBLE_EQ(result.vehicle.sprung_cg_height_m, result.given_cg_height_m);
        EXPECT_NEAR(said_ratio(result), seen_ratio(result), 0.03);
        EXPECT_THAT(origin_of_roll_centre(result),
                    HasSubstr("the nearest plausible; the wheel loads contradict"));
    }
}

TEST(KnownBodyTest, DoesNotFitACgHeightThatContradictsTheWheelLoads) {
    const sil::Identification beyond = contradicted(0.8);
    EXPECT_DOUBLE_EQ(beyond.vehicle.sprung_cg_height_m, beyond.given_cg_height_m);
    EXPECT_THAT(beyond.warnings, Contains(HasSubstr("It costs late and missed warnings")));
}

TEST(KnownBodyTest, MoreThanFifteenPerCentOfTheCgHeightIsAContradiction) {
    for (const double share : {0.842, 0.845}) {
        const sil::Identification result = contradicted(share);
        EXPECT_NEAR(result.loads->agreeing_cg_height_m / result.given_cg_height_m, 1.15, 0.003) << share;
        EXPECT_EQ(result.loads->contradicts_data, share < 0.8435) << share;
        EXPECT_EQ(result.vehicle.sprung_cg_height_m == result.given_cg_height_m, share < 0.8435) << share;
    }
}

}  // namespace
