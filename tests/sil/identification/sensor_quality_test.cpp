// Sensor quality: noise and steps of a known size are found, and good sensors need no setting.
#include "sil/studies/identification/sensor_quality.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sil/random.hpp"
#include "sil/studies/identification/calibration_writer.hpp"
#include "sil/studies/identification/identification.hpp"
#include "tests/sil/identification/known_body.hpp"

namespace {

using identification_test::KnownBody;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

sil::Drive ramp() {
    return identification_test::ramp_of(KnownBody{}, 5.5);
}

sil::Drive steps() {
    return identification_test::steps_of(KnownBody{});
}

sil::Drive noisy(sil::Drive drive, double sil::DriveSample::* force, double rms) {
    sil::RandomStream random{1U};
    for (sil::DriveSample& sample : drive.samples) {
        double normal = 0.0;  // nearly: a sum of twelve uniform numbers, whose variance is 1
        for (int i = 0; i < 12; ++i) {
            normal += random.between(-0.5, 0.5);
        }
        sample.*force += rms * normal;
    }
    return drive;
}

// Gathers speed from standing, in steps of so much.
sil::Drive coarse(sil::Drive drive, double step_mps) {
    for (std::size_t i = 0U; i < drive.samples.size(); ++i) {
        drive.samples[i].speed_mps = step_mps * std::floor(0.01 * static_cast<double>(i) / step_mps);
    }
    return drive;
}

TEST(SensorQuality, OfFineAndQuietSensorsNeedsNoSetting) {
    const sil::SensorQuality quality = sil::sensor_quality({coarse(ramp(), 0.04)}, {steps()});
    EXPECT_EQ(quality.accelerometer_noise_mps2, 0.0);
    EXPECT_EQ(quality.speed_resolution_mps, 0.0);
}

TEST(SensorQuality, FindsTheNoiseOfEitherAccelerometer) {
    for (const auto force :
         {&sil::DriveSample::lateral_acceleration_mps2, &sil::DriveSample::vertical_acceleration_mps2}) {
        EXPECT_NEAR(sil::sensor_quality({noisy(ramp(), force, 0.6)}, {}).accelerometer_noise_mps2, 0.6, 0.03);
        EXPECT_EQ(sil::sensor_quality({noisy(ramp(), force, 0.25)}, {}).accelerometer_noise_mps2, 0.0);
    }
}

TEST(SensorQuality, TakesNeitherAPotholeNorTheEndOfAGapForNoise) {
    sil::Drive drive = steps();
    for (std::size_t i = 0U; i < drive.samples.size(); ++i) {
        drive.samples[i].vertical_acceleration_mps2 += i % 50U == 0U ? 30.0 : 0.0;
        drive.samples[i].time_s *= 4.0;  // further apart than what is bridged
        drive.samples[i].lateral_acceleration_mps2 += i % 2U == 0U ? 5.0 : -5.0;
    }
    EXPECT_EQ(sil::sensor_quality({drive}, {}).accelerometer_noise_mps2, 0.0);
}

TEST(SensorQuality, FindsTheStepsOfASpeed) {
    EXPECT_NEAR(sil::sensor_quality({ramp()}, {coarse(steps(), 1.0 / 3.6)}).speed_resolution_mps, 1.0 / 3.6,
                1e-9);
    EXPECT_NEAR(sil::sensor_quality({coarse(ramp(), 0.06)}, {}).speed_resolution_mps, 0.06, 1e-9);
}

// A restart or a lost wheel: two changes are no pattern.
TEST(SensorQuality, DoesNotTakeASingleJumpForTheSteps) {
    sil::Drive drive = ramp();
    drive.samples[100].speed_mps += 3.0;
    EXPECT_EQ(sil::sensor_quality({drive}, {}).speed_resolution_mps, 0.0);
}

TEST(SensorQuality, IsWrittenToTheCalibrationAndTold) {
    const KnownBody body;
    const sil::Drive rough = noisy(ramp(), &sil::DriveSample::vertical_acceleration_mps2, 0.8);
    const sil::Identification result =
        sil::identify(identification_test::data_sheet_of(body), {rough}, {steps()});
    EXPECT_THAT(sil::calibration_text(result), HasSubstr("\naccelerometer_noise_mps2 = 0.8"));
    EXPECT_THAT(sil::calibration_text(result), HasSubstr("\nspeed_resolution_mps = 0.01\n"));
    EXPECT_THAT(result.warnings, Contains(HasSubstr("accelerometer_noise_mps2")));
    const sil::Identification quiet =
        sil::identify(identification_test::data_sheet_of(body), {ramp()}, {steps()});
    EXPECT_THAT(sil::calibration_text(quiet), HasSubstr("\naccelerometer_noise_mps2 = 0.0\n"));
    EXPECT_THAT(quiet.warnings, Not(Contains(HasSubstr("accelerometer_noise_mps2"))));
}

TEST(SensorQuality, BeyondWhatTheComponentAdmitsIsToldAndBounded) {
    const sil::Drive raw = noisy(ramp(), &sil::DriveSample::vertical_acceleration_mps2, 6.0);
    const sil::Identification result =
        sil::identify(identification_test::data_sheet_of(KnownBody{}), {raw},
                      {noisy(steps(), &sil::DriveSample::vertical_acceleration_mps2, 6.0)});
    const std::string text = sil::calibration_text(result);
    EXPECT_THAT(text, HasSubstr("\naccelerometer_noise_mps2 = 1.66"));  // of 2, less a reserve of 20 %
    EXPECT_THAT(text, HasSubstr("is beyond what the component admits after a correction"));
    EXPECT_THAT(result.warnings, Contains(testing::AllOf(HasSubstr("accelerometer_noise_mps2 would be"),
                                                         HasSubstr("after a correction"))));
}

}  // namespace
