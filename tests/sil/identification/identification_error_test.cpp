// Drives that are of no use are refused with what is wrong and what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sil/studies/identification/identification.hpp"
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
        EXPECT_THAT(refusal(good_ramp(), steps), HasSubstr("Check sign and unit")) << factor;
    }
}

TEST(DoubtfulDrive, WithoutSteeringTheGradientIsAssumedAndSaidSo) {
    identification_test::Recording recording;
    recording.steering = false;
    const KnownBody body;
    const sil::Identification result = sil::identify(identification_test::data_sheet_of(body),
                                                     {identification_test::ramp_of(body, 5.5, recording)},
                                                     {identification_test::steps_of(body, recording)});
    EXPECT_FALSE(result.steering);
    EXPECT_THAT(result.warnings, testing::Contains(HasSubstr("no ramp has steering-wheel angle")));
}

}  // namespace
