// A roll angle against gravity in place of one against the road, on a road that lets one tell.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "sil/studies/identification/identification.hpp"
#include "tests/sil/identification/known_body.hpp"

namespace {

using identification_test::KnownBody;
using identification_test::Recording;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

double slow_waves(double time_s) {
    return time_s < 2.0 ? 0.0 : 0.03 * std::sin(0.4 * (time_s - 2.0));
}

std::vector<std::string> warnings(const std::function<double(double)>& bank_rad, bool against_gravity,
                                  std::optional<sil::RollReference> said = {}, double sideslip_mps2 = 0.0) {
    const KnownBody body;
    sil::VehicleData vehicle = identification_test::data_sheet_of(body);
    vehicle.roll_angle_reference = said;
    Recording recording;
    recording.bank_rad = bank_rad;
    recording.roll_against_gravity = against_gravity;
    recording.wheel_loads = false;
    recording.sideslip_mps2 = [sideslip_mps2](double time_s) {
        return time_s < 1.0 ? 0.0 : sideslip_mps2 * std::sin(1.9 * (time_s - 1.0));
    };
    return sil::identify(vehicle, {identification_test::ramp_of(body, 5.5, recording)},
                         {identification_test::steps_of(body, recording)})
        .warnings;
}

TEST(RollReference, AnAngleThatFollowsTheBankIsOneAgainstGravity) {
    EXPECT_THAT(warnings(slow_waves, true), Contains(HasSubstr("moves with the road's bank")));
    EXPECT_THAT(warnings(slow_waves, true), Contains(HasSubstr("roll_angle_reference = \"horizon\"")));
    EXPECT_THAT(warnings(slow_waves, true), Contains(HasSubstr("the road is not level")));
    EXPECT_THAT(warnings(slow_waves, false), Not(Contains(HasSubstr("against gravity"))));
}

TEST(RollReference, AnAngleThatShowsTheBankOfTheStraightIsOneAgainstGravity) {
    const auto bank = [](double) { return 0.02; };
    EXPECT_THAT(warnings(bank, true), Contains(HasSubstr("show the same bank")));
    EXPECT_THAT(warnings(bank, false), Not(Contains(HasSubstr("against gravity"))));
}

TEST(RollReference, AnAngleThatIsSaidToBeOneAgainstTheHorizonMakesNoDoubtButOfTheRoad) {
    const auto bank = [](double) { return 0.02; };
    const auto said = warnings(bank, true, sil::RollReference::horizon);
    EXPECT_THAT(said, Not(Contains(HasSubstr("against gravity"))));
    EXPECT_THAT(said, Contains(HasSubstr("the road is not level")));
}

TEST(RollReference, AnAngleThatDoesNotFollowTheBankIsOneAgainstTheRoad) {
    EXPECT_THAT(warnings(slow_waves, false, sil::RollReference::horizon),
                Contains(HasSubstr("seems to be one against the road")));
    EXPECT_THAT(warnings(slow_waves, true, sil::RollReference::horizon),
                Not(Contains(HasSubstr("seems to be one against the road"))));
    EXPECT_THAT(warnings(slow_waves, false), Not(Contains(HasSubstr("roll_angle_reference"))));
}

// There both are the same.
TEST(RollReference, ALevelRoadDoesNotTell) {
    const auto level = [](double) { return 0.0; };
    EXPECT_THAT(warnings(level, true), Not(Contains(HasSubstr("against gravity"))));
    EXPECT_THAT(warnings(level, true, sil::RollReference::horizon),
                Not(Contains(HasSubstr("against the road;"))));
}

// Sideslip that grows and shrinks looks to an accelerometer like a bank, by more than 3 deg; the body does
// not turn with it.
TEST(RollReference, SideslipOnALevelRoadDoesNotTell) {
    const auto level = [](double) { return 0.0; };
    for (const auto said : {sil::RollReference::road, sil::RollReference::horizon}) {
        const auto all = warnings(level, true, said, 0.8);
        EXPECT_THAT(all, Not(Contains(HasSubstr("bank moves")))) << all.front();
        EXPECT_THAT(all, Not(Contains(HasSubstr("roll_angle_reference"))));
        EXPECT_THAT(all, Not(Contains(HasSubstr("the road is not level"))));
    }
}

TEST(RollReference, SideslipDoesNotHideABankThatIsLarger) {
    EXPECT_THAT(warnings(slow_waves, true, {}, 0.15), Contains(HasSubstr("moves with the road's bank")));
    EXPECT_THAT(warnings(slow_waves, false, sil::RollReference::horizon, 0.15),
                Contains(HasSubstr("seems to be one against the road")));
}

// One turn to each side, banked like a test track's curves.
TEST(RollReference, ABankOfTheCurvesIsTold) {
    const auto curves = [](double time_s) {
        return time_s < 1.0 || time_s > 61.0 ? 0.0 : 0.04 * std::sin(0.10472 * (1.0 - time_s));
    };
    EXPECT_THAT(warnings(curves, true), Contains(HasSubstr("moves with the road's bank")));
    EXPECT_THAT(warnings(curves, false, sil::RollReference::horizon),
                Contains(HasSubstr("seems to be one against the road")));
}

// The suspension is known from a level ramp; otherwise a bank that comes with the turn would be taken for a
// soft one.
TEST(RollReference, ABankOfTheDynamicDriveAloneIsTold) {
    const KnownBody body;
    for (const bool against_gravity : {false, true}) {
        Recording banked;
        banked.roll_against_gravity = against_gravity;
        banked.bank_rad = [](double time_s) { return 0.07 * std::clamp(0.5 * (time_s - 1.5), 0.0, 1.0); };
        const sil::Drive ramp = identification_test::drive_of(
            body, 8.0, [](double time_s) { return 0.7 * std::max(time_s - 1.0, 0.0); });
        const sil::Drive turn = identification_test::drive_of(
            body, 15.0, [](double time_s) { return 5.0 * std::clamp(2.0 * (time_s - 1.0), 0.0, 1.0); },
            banked);
        sil::VehicleData vehicle = identification_test::data_sheet_of(body);
        vehicle.roll_angle_reference =
            against_gravity ? sil::RollReference::road : sil::RollReference::horizon;
        const auto said = sil::identify(vehicle, {ramp}, {turn}).warnings;
        EXPECT_THAT(said, Contains(HasSubstr(against_gravity ? "seems to be one against gravity"
                                                             : "seems to be one against the road")));
    }
}

// A sensor of the suspension does not see what the tyres give in a turn; a gyro does.
TEST(RollReference, TyresThatRollAreNoBank) {
    KnownBody body;
    body.stiffness_cubic_nmprad3 = 0.0;
    sil::Drive ramp = identification_test::ramp_of(body, 6.5), steps = identification_test::steps_of(body);
    for (sil::Drive* drive : {&ramp, &steps}) {
        for (sil::DriveSample& sample : drive->samples) {
            sample.roll_angle_rad *= 0.7;
        }
    }
    for (const auto said : {sil::RollReference::road, sil::RollReference::horizon}) {
        sil::VehicleData vehicle = identification_test::data_sheet_of(body);
        vehicle.roll_angle_reference = said;
        EXPECT_THAT(sil::identify(vehicle, {ramp}, {steps}).warnings,
                    Not(Contains(HasSubstr("roll_angle_reference"))));
    }
}

}  // namespace
