// Drives that are of no use are refused with what is wrong and what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sil/studies/identification/identification.hpp"
#include "sil/studies/identification/plausibility_checks.hpp"
#include "sil/studies/identification/signs_and_units.hpp"
#include "tests/sil/identification/known_body.hpp"

namespace {

using identification_test::KnownBody;
using testing::AllOf;
using testing::HasSubstr;

std::string refusal(const sil::Drive& ramp, const sil::Drive& dynamic) {
    try {
        sil::identify(identification_test::data_sheet_of(KnownBody{}), {ramp}, {dynamic});
    } catch (const sil::IdentificationError& error) {
        return error.what();
    }
    return "accepted";
}

sil::Drive good_ramp() {
    return identification_test::ramp_of(KnownBody{}, 5.5);
}
sil::Drive good_steps() {
    return identification_test::steps_of(KnownBody{});
}

TEST(UselessDrive, WithoutRollAngleIsRefused) {
    sil::Drive ramp = good_ramp();
    for (sil::DriveSample& sample : ramp.samples) {
        sample.roll_angle_rad = sil::DriveSample::not_available;
    }
    EXPECT_THAT(refusal(ramp, good_steps()),
                AllOf(HasSubstr("known_body"), HasSubstr("no roll angle"), HasSubstr("add a column")));
}

TEST(UselessDrive, ARampThatHardlyTurnsIsRefused) {
    EXPECT_THAT(refusal(identification_test::ramp_of(KnownBody{}, 0.5), good_steps()),
                AllOf(HasSubstr("the ramp reaches only 0.05 g"), HasSubstr("Steer slowly on")));
}

TEST(UselessDrive, ADynamicDriveThatIsSlowIsRefused) {
    EXPECT_THAT(refusal(good_ramp(), good_ramp()),
                AllOf(HasSubstr("the body rolls with"), HasSubstr("Drive a step steer")));
}

TEST(UselessDrive, OneThatIsOverBeforeItBeginsIsRefused) {
    sil::Drive ramp = good_ramp();
    ramp.one_wheel_lift_s = 0.2;
    EXPECT_THAT(refusal(ramp, good_steps()),
                AllOf(HasSubstr("only 0.20 s can be used"), HasSubstr("a wheel lifts")));
}

TEST(UselessDrive, NoDriveAtAllIsRefused) {
    const sil::VehicleData data = identification_test::data_sheet_of(KnownBody{});
    EXPECT_THROW(sil::identify(data, {}, {good_steps()}), sil::IdentificationError);
    EXPECT_THROW(sil::identify(data, {good_ramp()}, {}), sil::IdentificationError);
}

TEST(UselessDrive, ABodyThatLeansIntoTheTurnIsRefused) {
    sil::Drive ramp = good_ramp();
    for (sil::DriveSample& sample : ramp.samples) {
        sample.roll_angle_rad = -sample.roll_angle_rad;
        sample.roll_rate_radps = -sample.roll_rate_radps;
    }
    EXPECT_THAT(refusal(ramp, good_steps()), HasSubstr("leans into the turn. Check the signs"));
}

TEST(UselessDrive, ARollRateInTheWrongUnitOrSignIsRefused) {
    for (const double factor : {-1.0, 57.3}) {
        sil::Drive steps = good_steps();
        for (sil::DriveSample& sample : steps.samples) {
            sample.roll_rate_radps *= factor;
        }
        EXPECT_THAT(refusal(good_ramp(), steps),
                    AllOf(HasSubstr("Check sign and unit"), HasSubstr("that the road is level")))
            << factor;
    }
}

// One column of one drive times `factor`.
sil::Drive scaled(sil::Drive drive, double sil::DriveSample::* column, double factor) {
    for (sil::DriveSample& sample : drive.samples) {
        sample.*column *= factor;
    }
    return drive;
}

TEST(UselessDrive, AYawRateOfTheOtherSignIsRefusedForThat) {
    const sil::Drive flipped = scaled(good_ramp(), &sil::DriveSample::yaw_rate_radps, -1.0);
    EXPECT_THAT(refusal(flipped, good_steps()),
                AllOf(HasSubstr("lateral acceleration and yaw rate have opposite signs"),
                      HasSubstr("turn the sign")));
    EXPECT_THAT(refusal(good_ramp(), scaled(good_steps(), &sil::DriveSample::yaw_rate_radps, -1.0)),
                HasSubstr("lateral acceleration and yaw rate have opposite signs"));
}

TEST(UselessDrive, ASteeringAngleOfTheOtherSignIsRefusedForThat) {
    const sil::Drive flipped = scaled(good_ramp(), &sil::DriveSample::steering_wheel_angle_rad, -1.0);
    EXPECT_THAT(refusal(flipped, good_steps()),
                AllOf(HasSubstr("steering-wheel angle and yaw rate have opposite signs"),
                      HasSubstr("turn the sign of the steering-wheel angle")));
}

TEST(UselessDrive, AnAccelerationInAnotherUnitIsRefusedForThat) {
    for (const double factor : {9.80665, 1.0 / 9.80665}) {
        const sil::Drive wrong = scaled(good_ramp(), &sil::DriveSample::lateral_acceleration_mps2, factor);
        EXPECT_THAT(refusal(wrong, good_steps()),
                    AllOf(HasSubstr("times yaw rate times speed"), HasSubstr("m/s^2 in a column named _g")))
            << factor;
    }
}

TEST(UselessDrive, AYawRateInDegreesIsRefusedForThat) {
    EXPECT_THAT(refusal(scaled(good_ramp(), &sil::DriveSample::yaw_rate_radps, 57.3), good_steps()),
                HasSubstr("0.02 times yaw rate times speed"));
}

// A drive at 20 m/s from its turn (yaw rate times speed) and its lateral acceleration, both over the time.
template <typename Turn, typename Lateral>
std::string contradiction(const Turn& turn_mps2, const Lateral& lateral_mps2) {
    sil::Drive drive;
    drive.name = "a drive";
    sil::Cycles cycles;
    for (int k = 0; k < 800; ++k) {
        sil::DriveSample sample{};
        sample.time_s = 0.01 * k;
        sample.speed_mps = 20.0;
        sample.yaw_rate_radps = turn_mps2(sample.time_s) / sample.speed_mps;
        sample.lateral_acceleration_mps2 = lateral_mps2(sample.time_s);
        drive.samples.push_back(sample);
        cycles.push_back(sil::DriveCycle{true, sample});
    }
    try {
        sil::refuse_wrong_signs_and_units(drive, cycles, 0.02);
    } catch (const sil::IdentificationError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(SignsAndUnits, AStraightOverABankIsNoWrongSign) {
    const auto countersteers = [](double time_s) { return time_s > 2.0 ? -0.013 : 0.0; };
    const auto bank = [](double time_s) { return time_s > 2.0 ? 1.8 : 0.0; };
    EXPECT_EQ(contradiction(countersteers, bank), "accepted");
    EXPECT_THAT(contradiction(countersteers, [&](double time_s) { return 2.0 * bank(time_s); }),
                HasSubstr("opposite signs"));
}

TEST(SignsAndUnits, ASkidIsNoWrongUnit) {
    const auto spins = [](double time_s) { return 14.0 * std::sin(3.8 * time_s); };
    const auto skids = [](double time_s) { return 4.5 * std::sin(3.8 * time_s - 0.6); };
    EXPECT_EQ(contradiction(spins, skids), "accepted");
    EXPECT_THAT(contradiction(spins, [](double time_s) { return 4.5 * std::sin(3.8 * time_s - 0.1); }),
                HasSubstr("0.32 times yaw rate times speed"));
}

TEST(UselessDrive, BlowsAfterAWheelHasLiftedAreNoWrongUnit) {
    sil::Drive ramp = good_ramp();
    const std::size_t lift = 3U * ramp.samples.size() / 4U;
    ramp.one_wheel_lift_s = ramp.samples[lift].time_s;
    for (std::size_t k = lift + 1U; k < ramp.samples.size(); ++k) {
        ramp.samples[k].lateral_acceleration_mps2 = -400.0;
    }
    EXPECT_EQ(refusal(ramp, good_steps()), "accepted");
}

TEST(UselessDrive, ARollAngleInAnotherUnitIsRefusedForThat) {
    for (const double factor : {1.0 / 57.3, 57.3}) {
        EXPECT_THAT(refusal(scaled(good_ramp(), &sil::DriveSample::roll_angle_rad, factor), good_steps()),
                    AllOf(HasSubstr("known_body: the roll angle is"), HasSubstr("deg per g"),
                          HasSubstr("rad in a column named roll_angle_deg")))
            << factor;
    }
}

TEST(UselessDrive, WithoutYawRateTheSizeOfTheAccelerationTellsItsUnit) {
    sil::Drive wrong = scaled(good_ramp(), &sil::DriveSample::lateral_acceleration_mps2, 9.80665);
    sil::Drive right = good_ramp();
    for (sil::Drive* drive : {&wrong, &right}) {
        *drive = scaled(*drive, &sil::DriveSample::yaw_rate_radps, sil::DriveSample::not_available);
    }
    EXPECT_THAT(refusal(wrong, good_steps()),
                AllOf(HasSubstr("which no tyre gives"), HasSubstr("m/s^2 in a column named _g")));
    EXPECT_EQ(refusal(right, good_steps()), "accepted");
}

std::vector<std::string> doubts(double imu_z_m, double inertia_kgm2) {
    KnownBody body;
    body.inertia_kgm2 = inertia_kgm2;
    sil::VehicleData data = identification_test::data_sheet_of(body);
    data.imu_z_m = imu_z_m;
    return sil::identify(data, {identification_test::ramp_of(body, 5.5)},
                         {identification_test::steps_of(body)})
        .warnings;
}

TEST(DoubtfulDrive, AWrongSignOfTheImusHeightIsDoubtedByTheInertiaThatItMakes) {
    const KnownBody body;
    EXPECT_THAT(doubts(-body.imu_z_m, body.inertia_kgm2),
                testing::Contains(AllOf(HasSubstr("Ixx is "), HasSubstr("imu_z_m"))));
    for (const double usual_kgm2 : {600.0, body.inertia_kgm2, 900.0}) {
        EXPECT_THAT(doubts(body.imu_z_m, usual_kgm2), testing::Not(testing::Contains(HasSubstr("Ixx is "))))
            << usual_kgm2;
    }
}

// Each limit of a warning, one step inside and one outside.
class WarningLimit : public testing::Test {
 protected:
    static const sil::Identification& good() {
        static const sil::Identification result =
            sil::identify(identification_test::data_sheet_of(KnownBody{}), {good_ramp()}, {good_steps()});
        return result;
    }

    static bool warns(const sil::Identification& result, const char* text) {
        const auto warnings = sil::identification_warnings(result);
        return std::any_of(warnings.begin(), warnings.end(), [text](const std::string& warning) {
            return warning.find(text) != std::string::npos;
        });
    }
};

TEST_F(WarningLimit, HalfOfWhatTheRuleOfThumbLeavesOpenIsWeak) {
    for (const bool weak : {false, true}) {
        const double share = weak ? 0.51 : 0.49;
        sil::Identification result = good();
        result.roll.inertia_kgm2.deviation = share * result.roll.inertia_kgm2.prior_deviation;
        EXPECT_EQ(warns(result, "Ixx is weakly excited"), weak);
        result = good();
        result.roll.damping_nmsprad.deviation = share * result.roll.damping_nmsprad.prior_deviation;
        EXPECT_EQ(warns(result, "the damping is weakly excited"), weak);
    }
}

TEST_F(WarningLimit, FivePerCentStifferOrSofterInTheDynamicDriveIsSaid) {
    for (const double side : {-1.0, 1.0}) {
        for (const bool said : {false, true}) {
            sil::Identification result = good();
            result.roll.dynamic_stiffness_difference_nmprad.value =
                side * (said ? 0.051 : 0.049) * result.roll.stiffness_nmprad.value;
            EXPECT_EQ(warns(result, side > 0.0 ? "% stiffer than" : "% softer than"), said) << side;
        }
    }
}

// The other sign of imu_z_m is named only where it would come nearer to the usual inertia.
TEST_F(WarningLimit, TheOtherSignOfTheImusHeightIsNamedOnlyWhereItHelps) {
    const double usual = sil::usual_roll_inertia_kgm2(good().vehicle);
    for (const double imu_z_m : {-0.3, 0.0, 0.3}) {
        sil::Identification result = good();
        result.roll.inertia_kgm2.value = 1.5 * usual;
        result.vehicle.imu_z_m = imu_z_m;
        EXPECT_TRUE(warns(result, "Ixx is "));
        EXPECT_EQ(warns(result, "with the other sign"), imu_z_m > 0.0) << imu_z_m;
    }
}

TEST_F(WarningLimit, AnInertiaBeyondARuleOfThumbIsDoubted) {
    const double usual = sil::usual_roll_inertia_kgm2(good().vehicle);
    for (const double share : {0.39, 0.41, 1.29, 1.31}) {
        sil::Identification result = good();
        result.roll.inertia_kgm2.value = share * usual;
        EXPECT_EQ(warns(result, "Ixx is "), share < 0.4 || share > 1.3) << share;
    }
}

// Radius of gyration of a quarter of the track width to 0.65 of it.
TEST_F(WarningLimit, AGivenInertiaThatNoBodyHasIsDoubted) {
    const sil::VehicleData& vehicle = good().vehicle;
    for (const double share : {0.24, 0.26, 0.64, 0.66}) {
        sil::Identification result = good();
        result.vehicle.roll_inertia_kgm2 =
            vehicle.sprung_mass_kg * share * share * vehicle.track_width_m * vehicle.track_width_m;
        EXPECT_EQ(warns(result, "radius of gyration"), share < 0.25 || share > 0.65) << share;
    }
}

TEST_F(WarningLimit, ANegativeOrAbsurdUndersteerGradientIsDoubted) {
    for (const double gradient : {-0.0001, 0.0, 0.0149, 0.0151}) {
        sil::Identification result = good();
        result.steering->understeer_gradient_s2pm.value = gradient;
        EXPECT_EQ(warns(result, "the understeer gradient is"), gradient < 0.0 || gradient > 0.015)
            << gradient;
    }
}

TEST_F(WarningLimit, AResponseThatForecastsNoBetterThanTheTrendIsNone) {
    sil::Identification result = good();
    ASSERT_TRUE(result.response);
    result.response->at_a_bound = false;
    result.response->rms_mps2 = 0.99 * result.response->trend_rms_mps2;
    EXPECT_FALSE(warns(result, "does not show in the drives"));
    result.response->rms_mps2 = 1.01 * result.response->trend_rms_mps2;
    EXPECT_TRUE(warns(result, "does not show in the drives"));
    result.response->rms_mps2 = 0.0;
    result.response->at_a_bound = true;
    EXPECT_TRUE(warns(result, "at a bound of what is searched"));
}

TEST(DoubtfulDrive, WithoutSteeringTheGradientIsAssumedAndSaidSo) {
    identification_test::Recording recording;
    recording.steering = false;
    const KnownBody body;
    const sil::Identification result = sil::identify(identification_test::data_sheet_of(body),
                                                     {identification_test::ramp_of(body, 5.5, recording)},
                                                     {identification_test::steps_of(body, recording)});
    EXPECT_FALSE(result.steering);
    EXPECT_THAT(result.warnings, testing::Contains(AllOf(HasSubstr("no ramp has steering-wheel angle"),
                                                         HasSubstr("the lateral response w is 0"))));
}

// Seconds from straight to `largest_mps2`, which is held.
std::vector<std::string> said_of_ramp(double largest_mps2, double seconds, bool gradient_is_given = false) {
    const KnownBody body;
    sil::VehicleData data = identification_test::data_sheet_of(body);
    if (gradient_is_given) {
        data.understeer_gradient_s2pm = body.understeer_gradient_s2pm;
    }
    const sil::Drive ramp = identification_test::drive_of(body, 8.0, [=](double time_s) {
        return largest_mps2 * std::clamp((time_s - 1.0) / seconds, 0.0, 1.0);
    });
    return sil::identify(data, {ramp}, {good_steps()}).warnings;
}

// 5.5 m/s^2 need some 62 deg at the steering wheel.
TEST(DoubtfulDrive, ARampThatSteersTooFastIsToldAsThat) {
    const auto fast = said_of_ramp(5.5, 2.0);
    EXPECT_THAT(fast, testing::Contains(AllOf(HasSubstr("turns faster than 23 deg/s"),
                                              HasSubstr("the lateral response w is 0"))));
    EXPECT_THAT(fast, testing::Not(testing::Contains(HasSubstr("no ramp has steering-wheel angle"))));
    EXPECT_THAT(said_of_ramp(5.5, 2.0, true),
                testing::Contains(AllOf(HasSubstr("turns faster than 23 deg/s"),
                                        testing::Not(HasSubstr("the lateral response w is 0")))));
    EXPECT_THAT(said_of_ramp(5.5, 4.0), testing::Not(testing::Contains(HasSubstr("turns faster than"))));
}

TEST(DoubtfulDrive, ARampThatJumpsOverModerateTurnsIsToldAsThat) {
    EXPECT_THAT(said_of_ramp(5.5, 0.5), testing::Contains(HasSubstr("hardly ever between 0.1 and 0.4 g")));
}

TEST(DoubtfulDrive, ADriveThatStartsInATurnIsToldAsThat) {
    const sil::Drive ramp =
        identification_test::drive_of(KnownBody{}, 20.0, [](double time_s) { return 1.5 + 0.2 * time_s; });
    EXPECT_THAT(
        sil::identify(identification_test::data_sheet_of(KnownBody{}), {ramp}, {good_steps()}).warnings,
        testing::Contains(HasSubstr("long enough straight, as the steering-wheel angle shows")));
}

}  // namespace
