// A roll angle against gravity in place of one against the road, on a road that lets one tell.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sil/studies/identification/identification.hpp"
#include "tests/sil/identification/known_body.hpp"

namespace {

using identification_test::KnownBody;
using identification_test::Recording;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> warnings(const std::function<double(double)>& bank_rad, bool against_gravity) {
    const KnownBody body;
    Recording recording;
    recording.bank_rad = bank_rad;
    recording.roll_against_gravity = against_gravity;
    recording.wheel_loads = false;
    return sil::identify(identification_test::data_sheet_of(body),
                         {identification_test::ramp_of(body, 5.5, recording)},
                         {identification_test::steps_of(body, recording)})
        .warnings;
}

TEST(RollReference, AnAngleThatFollowsTheBankIsOneAgainstGravity) {
    const auto bank = [](double time_s) {
        return time_s < 2.0 ? 0.0 : 0.03 * std::sin(0.4 * (time_s - 2.0));
    };
    EXPECT_THAT(warnings(bank, true), Contains(HasSubstr("moves with the road's bank")));
    EXPECT_THAT(warnings(bank, false), Not(Contains(HasSubstr("against gravity"))));
}

TEST(RollReference, AnAngleThatShowsTheBankOfTheStraightIsOneAgainstGravity) {
    const auto bank = [](double) { return 0.02; };
    EXPECT_THAT(warnings(bank, true), Contains(HasSubstr("show the same bank")));
    EXPECT_THAT(warnings(bank, false), Not(Contains(HasSubstr("against gravity"))));
}

// There both are the same.
TEST(RollReference, ALevelRoadDoesNotTell) {
    const auto level = [](double) { return 0.0; };
    EXPECT_THAT(warnings(level, true), Not(Contains(HasSubstr("against gravity"))));
}

}  // namespace
