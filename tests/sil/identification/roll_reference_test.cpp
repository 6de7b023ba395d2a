// A roll angle against gravity in place of one against the road, on a road that lets one tell.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

std::vector<std::string> warnings(const std::function<double(double)>& bank_rad, bool against_gravity,
                                  std::optional<sil::RollReference> said = {}) {
    const KnownBody body;
    sil::VehicleData vehicle = identification_test::data_sheet_of(body);
    vehicle.roll_angle_reference = said;
    Recording recording;
    recording.bank_rad = bank_rad;
    recording.roll_against_gravity = against_gravity;
    recording.wheel_loads = false;
    return sil::identify(vehicle, {identification_test::ramp_of(body, 5.5, recording)},
                         {identification_test::steps_of(body, recording)})
        .warnings;
}

TEST(RollReference, AnAngleThatFollowsTheBankIsOneAgainstGravity) {
    const auto bank = [](double time_s) {
        return time_s < 2.0 ? 0.0 : 0.03 * std::sin(0.4 * (time_s - 2.0));
    };
    EXPECT_THAT(warnings(bank, true), Contains(HasSubstr("moves with the road's bank")));
    EXPECT_THAT(warnings(bank, true), Contains(HasSubstr("roll_angle_reference = \"horizon\"")));
    EXPECT_THAT(warnings(bank, true), Contains(HasSubstr("the road is not level")));
    EXPECT_THAT(warnings(bank, false), Not(Contains(HasSubstr("against gravity"))));
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
    const auto bank = [](double time_s) {
        return time_s < 2.0 ? 0.0 : 0.03 * std::sin(0.4 * (time_s - 2.0));
    };
    EXPECT_THAT(warnings(bank, false, sil::RollReference::horizon),
                Contains(HasSubstr("seems to be one against the road")));
    EXPECT_THAT(warnings(bank, true, sil::RollReference::horizon),
                Not(Contains(HasSubstr("seems to be one against the road"))));
    EXPECT_THAT(warnings(bank, false), Not(Contains(HasSubstr("roll_angle_reference"))));
}

// There both are the same.
TEST(RollReference, ALevelRoadDoesNotTell) {
    const auto level = [](double) { return 0.0; };
    EXPECT_THAT(warnings(level, true), Not(Contains(HasSubstr("against gravity"))));
    EXPECT_THAT(warnings(level, true, sil::RollReference::horizon),
                Not(Contains(HasSubstr("against the road;"))));
}

}  // namespace
