// The calibration that is written is complete, and equal for all vehicles where it must be.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "rsi/parameters.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/studies/identification/calibration_writer.hpp"
#include "sil/studies/identification/report.hpp"
#include "tests/sil/identification/known_body.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using identification_test::KnownBody;
using testing::HasSubstr;

class CalibrationOfAKnownBody : public testing::Test {
 protected:
    KnownBody body_{};
    sil::Identification result_{sil::identify(identification_test::data_sheet_of(body_),
                                              {identification_test::ramp_of(body_, 5.5)},
                                              {identification_test::steps_of(body_)})};

    rsi::Parameters written() const {
        const test_support::ScratchFolder folder;
        const std::string path = folder.path() / "calibration.toml";
        test_support::write_text(path, sil::calibration_text(result_));
        return sil::load_calibration(path);
    }
};

TEST_F(CalibrationOfAKnownBody, IsAcceptedByTheComponentAndBearsTheValues) {
    const rsi::Parameters parameters = written();
    EXPECT_NEAR(parameters.roll_stiffness_nmprad, 88.0e3, 900.0);
    EXPECT_NEAR(parameters.roll_damping_nmsprad, 4200.0, 42.0);
    EXPECT_NEAR(parameters.roll_inertia_kgm2, 720.0, 7.2);
    EXPECT_NEAR(parameters.fixed_roll_centre_height_m, 0.18, 0.005);
    EXPECT_NEAR(parameters.sprung_mass_kg, 1900.0, 0.1);
    EXPECT_NEAR(parameters.unsprung_mass_kg, 280.0, 0.1);
    EXPECT_NEAR(parameters.steering_ratio, 17.5, 0.01);
    EXPECT_NEAR(parameters.imu_z_m, -0.3, 1e-6);
}

TEST_F(CalibrationOfAKnownBody, DiffersFromTheLargeSuvsOnlyWhereTheVehicleDoes) {
    const rsi::Parameters parameters = written();
    const rsi::Parameters defaults =
        sil::load_calibration(RSI_SOURCE_DIR "/firmware/calibrations/large_suv.toml");
    std::set<std::string> identified;
    for (const sil::IdentifiedValue& value : result_.values) {
        identified.insert(value.key);
    }
    for (const char* fixed : {"advisory_on", "warning_on", "warning_off", "prediction_horizon_s"}) {
        EXPECT_EQ(identified.count(fixed), 0U) << fixed;
    }
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        if (identified.count(field.name) == 0U) {
            EXPECT_EQ(parameters.*field.member, defaults.*field.member) << field.name;
        }
    }
    EXPECT_EQ(parameters.estimator, defaults.estimator);
    EXPECT_EQ(parameters.warning_indicator, defaults.warning_indicator);
    EXPECT_EQ(parameters.roll_angle_reference, RSI_ROLL_AGAINST_ROAD);
}

TEST_F(CalibrationOfAKnownBody, HasTheRollAnglesReferenceThatTheVehicleDataSay) {
    result_.values.push_back({"roll_angle_reference", RSI_ROLL_AGAINST_HORIZON, "vehicle data"});
    EXPECT_EQ(written().roll_angle_reference, RSI_ROLL_AGAINST_HORIZON);
    EXPECT_THAT(sil::calibration_text(result_),
                HasSubstr("\nroll_angle_reference = \"horizon\"  # vehicle data\n"));
}

TEST_F(CalibrationOfAKnownBody, NamesTheVehicleTheDrivesAndEachOrigin) {
    const std::string text = sil::calibration_text(result_);
    EXPECT_THAT(text, HasSubstr("known body"));
    EXPECT_THAT(text, HasSubstr("Slow ramps: known_body"));
    for (const sil::IdentifiedValue& value : result_.values) {
        EXPECT_THAT(text, HasSubstr("\n" + value.key + " = "));
        EXPECT_THAT(text, HasSubstr("# " + value.origin));
    }
}

TEST_F(CalibrationOfAKnownBody, ANameWithALineBreakStaysAComment) {
    result_.vehicle.name = "two\nwarning_on = 0.1";
    EXPECT_NO_THROW(written());
}

TEST_F(CalibrationOfAKnownBody, ReportGivesFitQualityOfEveryDrive) {
    const std::string report = sil::identification_report(result_);
    EXPECT_THAT(report, HasSubstr("stiffness K_f"));
    EXPECT_THAT(report, HasSubstr("condition number"));
    EXPECT_THAT(report, HasSubstr("R2"));
    EXPECT_THAT(report, HasSubstr("effective h_rc"));
}

}  // namespace
