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
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

rsi::Parameters read_back(const sil::Identification& result) {
    const test_support::ScratchFolder folder;
    const std::string path = folder.path() / "calibration.toml";
    test_support::write_text(path, sil::calibration_text(result));
    return sil::load_calibration(path);
}

class CalibrationOfAKnownBody : public testing::Test {
 protected:
    KnownBody body_{};
    sil::Identification result_{sil::identify(identification_test::data_sheet_of(body_),
                                              {identification_test::ramp_of(body_, 5.5)},
                                              {identification_test::steps_of(body_)})};

    rsi::Parameters written() const { return read_back(result_); }
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

TEST_F(CalibrationOfAKnownBody, KeepsWhatIsDoubtedOfIt) {
    result_.warnings = {"the ramp is short\nwarning_on = 0.1", "Ixx is large"};
    EXPECT_NO_THROW(written());
    EXPECT_THAT(sil::doubts_in(sil::calibration_text(result_)),
                ElementsAre("the ramp is short warning_on = 0.1", "Ixx is large"));
}

TEST_F(CalibrationOfAKnownBody, ANameWithALineBreakStaysAComment) {
    result_.vehicle.name = "two\nwarning_on = 0.1";
    EXPECT_NO_THROW(written());
}

// A truck whose stops are so stiff that the component has no room for what fits best. The roll centre lies on
// the road, or is taken there: below the usual one of the rules of thumb, and only with the arm that this
// gives are the coefficients beyond their ranges.
KnownBody truck(double stiffness_nmprad, double cubic_nmprad3, double quintic_nmprad5) {
    KnownBody body;
    body.sprung_mass_kg = 9600.0;
    body.unsprung_mass_kg = 1650.0;
    body.sprung_cg_height_m = 1.12;
    body.unsprung_cg_height_m = 0.46;
    body.track_width_m = 1.9;
    body.roll_centre_height_m = 0.0;
    body.stiffness_nmprad = stiffness_nmprad;
    body.stiffness_cubic_nmprad3 = cubic_nmprad3;
    body.stiffness_quintic_nmprad5 = quintic_nmprad5;
    body.damping_nmsprad = 6.0e4;
    body.inertia_kgm2 = 6500.0;
    body.wheelbase_m = 4.2;
    return body;
}

TEST(CalibrationOfATruck, StaysWithinTheRangesOfTheStiffnessCurve) {
    for (const KnownBody& body : {truck(1.2e6, 0.0, 1.4e10), truck(3.0e6, 2.0e8, 0.0)}) {
        for (const bool wheel_loads : {false, true}) {
            identification_test::Recording recording;
            recording.wheel_loads = wheel_loads;
            const sil::Identification result =
                sil::identify(identification_test::data_sheet_of(body),
                              {identification_test::ramp_of(body, 6.5, recording)},
                              {identification_test::steps_of(body, recording)});
            EXPECT_THAT(result.warnings, Contains(HasSubstr("beyond what the component admits")));
            read_back(result);
            // By the fit, before anything is clamped.
            EXPECT_LE(std::abs(result.roll.stiffness_cubic_nmprad3.value), 1.0e8 / 1.2);
            EXPECT_LE(std::abs(result.roll.stiffness_quintic_nmprad5.value), 1.0e10 / 1.2);
            for (double phi = 0.005; phi < result.roll.data_end_rad; phi += 0.005) {
                EXPECT_NEAR(result.roll.moment_nm(phi), body.moment_nm(phi), 0.02 * body.moment_nm(phi))
                    << phi;
            }
        }
    }
}

// A value that is 20 % off is corrected with --set; the component must not refuse that.
TEST(CalibrationOfAnOddBody, BearsACorrectionOfEachFittedValue) {
    KnownBody undamped;
    undamped.damping_nmsprad = 350.0;
    for (const KnownBody& body :
         {KnownBody{}, undamped, truck(1.2e6, 0.0, 1.4e10), truck(3.0e6, 2.0e8, 0.0)}) {
        const rsi::Parameters written = read_back(sil::identify(identification_test::data_sheet_of(body),
                                                                {identification_test::ramp_of(body, 6.5)},
                                                                {identification_test::steps_of(body)}));
        for (const auto member :
             {&rsi::Parameters::roll_inertia_kgm2, &rsi::Parameters::fixed_roll_centre_height_m,
              &rsi::Parameters::roll_damping_nmsprad, &rsi::Parameters::roll_stiffness_cubic_nmprad3,
              &rsi::Parameters::roll_stiffness_quintic_nmprad5, &rsi::Parameters::understeer_gradient_s2pm,
              &rsi::Parameters::largest_lateral_acceleration_mps2,
              &rsi::Parameters::lateral_response_damping}) {
            for (const float share : {0.8F, 1.2F}) {
                rsi::Parameters corrected = written;
                corrected.*member *= share;
                const rsi::Validation validation = rsi::validate(corrected);
                EXPECT_EQ(validation.accepted, 1) << validation.field << " " << validation.reason << share;
            }
        }
        rsi::Parameters stiffer = written;
        stiffer.roll_stiffness_nmprad *= 1.2F;
        EXPECT_EQ(rsi::validate(stiffer).accepted, 1) << body.damping_nmsprad;
    }
}

// Both the stiffness and the least damping for it would leave the range: they are bounded, the damping by the
// stiffness that is written.
TEST(CalibrationOfAnOddBody, HasADampingThatFitsItsBoundedStiffness) {
    KnownBody body = truck(9.5e6, 0.0, 0.0);
    body.sprung_mass_kg = 45000.0;
    body.inertia_kgm2 = 30000.0;
    body.damping_nmsprad = 2.0e4;
    const sil::Identification result =
        sil::identify(identification_test::data_sheet_of(body), {identification_test::ramp_of(body, 6.5)},
                      {identification_test::steps_of(body)});
    const double written_nmprad = result.value("roll_stiffness_nmprad");
    EXPECT_NEAR(written_nmprad, 1.0e7 / 1.201, 1.0);
    EXPECT_NEAR(result.value("roll_damping_nmsprad"), 1.001 / 0.8 * 0.005 * written_nmprad, 1.0);
    EXPECT_THAT(result.warnings, Contains(HasSubstr("roll_stiffness_nmprad would be")));
    read_back(result);
}

TEST_F(CalibrationOfAKnownBody, IsNotLimitedWhereTheComponentAdmitsTheCurve) {
    EXPECT_FALSE(result_.roll.curve_limited);
    EXPECT_THAT(result_.warnings, Not(Contains(HasSubstr("beyond what the component admits"))));
}

TEST_F(CalibrationOfAKnownBody, ReportGivesFitQualityOfEveryDrive) {
    const std::string report = sil::identification_report(result_);
    EXPECT_THAT(report, HasSubstr("stiffness K_f"));
    EXPECT_THAT(report, HasSubstr("condition number"));
    EXPECT_THAT(report, HasSubstr("R2"));
    EXPECT_THAT(report, HasSubstr("effective h_rc"));
}

}  // namespace
