// The calibration: every field is known, ranged and refused by its name.
#include "rsi/parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <set>
#include <string>

#include "rsi/model/critical_roll_angle.hpp"
#include "tests/rsi/support/nominal.hpp"

namespace parameters_test {
namespace {

std::ptrdiff_t offset_of(float rsi_parameters::* member) {
    static const rsi_parameters parameters{};
    return reinterpret_cast<const char*>(&(parameters.*member)) - reinterpret_cast<const char*>(&parameters);
}

void expect_refused(const rsi_parameters& parameters, const char* field) {
    const rsi_validation answer = rsi::validate(parameters);
    EXPECT_EQ(answer.accepted, 0) << field;
    EXPECT_STREQ(answer.field, field);
    EXPECT_GT(std::strlen(answer.reason), 0U);
}

TEST(Parameters, TheNominalVehicleIsAccepted) {
    const rsi_validation answer = rsi::validate(rsi_test::large_suv());
    EXPECT_EQ(answer.accepted, 1);
    EXPECT_STREQ(answer.field, "");
    EXPECT_STREQ(answer.reason, "");
}

// The floats fill the structure from its start to the selections without a gap, so every one of them is in
// the table.
TEST(Parameters, TheTableHoldsEveryNumberOnceAndInOrder) {
    std::ptrdiff_t expected = 0;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        EXPECT_EQ(offset_of(field.member), expected) << field.name;
        expected += static_cast<std::ptrdiff_t>(sizeof(float));
    }
    EXPECT_EQ(expected, static_cast<std::ptrdiff_t>(offsetof(rsi_parameters, estimator)));
}

TEST(Parameters, TheTableHoldsEverySelection) {
    EXPECT_EQ(offsetof(rsi_parameters, estimator) + rsi::selection_fields.size() * sizeof(std::int32_t),
              sizeof(rsi_parameters));
}

TEST(Parameters, EveryNameIsItsOwn) {
    std::set<std::string> names;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        EXPECT_TRUE(names.insert(field.name).second) << field.name;
        EXPECT_LT(field.minimum, field.maximum) << field.name;
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        EXPECT_TRUE(names.insert(field.name).second) << field.name;
    }
}

TEST(Parameters, EachFieldIsRefusedByNameWhenItIsNotFinite) {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        for (const float bad : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity}) {
            rsi_parameters parameters = rsi_test::large_suv();
            parameters.*field.member = bad;
            expect_refused(parameters, field.name);
        }
    }
}

TEST(Parameters, EachFieldIsRefusedByNameJustOutsideItsRange) {
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.*field.member = std::nextafterf(field.minimum, -1.0e30F);
        expect_refused(parameters, field.name);
        parameters.*field.member = std::nextafterf(field.maximum, 1.0e30F);
        expect_refused(parameters, field.name);
    }
}

// The limits belong to the range: what is refused there, if anything, is refused by a rule between fields.
TEST(Parameters, TheLimitsThemselvesAreInRange) {
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        for (const float limit : {field.minimum, field.maximum}) {
            rsi_parameters parameters = rsi_test::large_suv();
            parameters.*field.member = limit;
            EXPECT_EQ(std::string(rsi::validate(parameters).reason).find("its range"), std::string::npos)
                << field.name;
        }
    }
}

TEST(Parameters, SelectionsOutsideTheirChoicesAreRefusedByName) {
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        for (const std::int32_t bad : {-1, field.choice_count, std::numeric_limits<std::int32_t>::max()}) {
            rsi_parameters parameters = rsi_test::large_suv();
            parameters.*field.member = bad;
            expect_refused(parameters, field.name);
        }
    }
}

TEST(Parameters, TheChoicesAreNamedInTheOrderOfTheirNumbers) {
    EXPECT_STREQ(rsi::estimator_choices[RSI_ESTIMATOR_PUBLISHED], "published");
    EXPECT_STREQ(rsi::indicator_choices[RSI_INDICATOR_PUBLISHED], "published");
    EXPECT_STREQ(rsi::indicator_choices[RSI_INDICATOR_BANK_FREE], "bank_free");
}

TEST(Parameters, TheRollCentreMustLieBelowTheCentreOfGravity) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.fixed_roll_centre_height_m = parameters.sprung_cg_height_m;
    expect_refused(parameters, "fixed_roll_centre_height_m");
    parameters.fixed_roll_centre_height_m = parameters.sprung_cg_height_m + 0.1F;
    expect_refused(parameters, "fixed_roll_centre_height_m");
}

TEST(Parameters, TheRollStiffnessMustHoldTheBodyUp) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.track_width_m = 1.2F;  // narrow enough that even such springs lift the inner wheels
    const float least = 1.2F * 2060.0F * 9.80665F * (0.988F - 0.281F);
    parameters.roll_stiffness_nmprad = 0.99F * least;
    expect_refused(parameters, "roll_stiffness_nmprad");
    parameters.roll_stiffness_nmprad = 1.01F * least;
    EXPECT_EQ(rsi::validate(parameters).accepted, 1);
}

// 1.21 m_s g H on 1.6 m: k phi - c_w/(2h) - (h_frc/h) tan phi stays below zero up to 1 rad.
TEST(Parameters, ThereMustBeARollAngleThatLiftsTheInnerWheels) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.roll_stiffness_nmprad = 1.21F * 2060.0F * 9.80665F * (0.988F - 0.281F);
    expect_refused(parameters, "roll_stiffness_nmprad");
}

TEST(Parameters, ALateralResponseIsUnknownOrFastEnoughToBeOne) {
    rsi_parameters parameters = rsi_test::large_suv();
    for (const float accepted_radps : {0.0F, -0.0F, 1.0F, 60.0F}) {
        parameters.lateral_response_frequency_radps = accepted_radps;
        EXPECT_EQ(rsi::validate(parameters).accepted, 1) << accepted_radps;
    }
    for (const float refused_radps : {std::nextafterf(0.0F, 1.0F), 0.5F, std::nextafterf(1.0F, 0.0F)}) {
        parameters.lateral_response_frequency_radps = refused_radps;
        expect_refused(parameters, "lateral_response_frequency_radps");
    }
}

TEST(Parameters, TheRolloverIndexsWeightsMustLeaveRoomForTheThird) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.rollover_index_angle_weight = 0.75F;
    parameters.rollover_index_acceleration_weight = 0.25F;
    EXPECT_EQ(rsi::validate(parameters).accepted, 1);
    parameters.rollover_index_acceleration_weight = 0.26F;
    expect_refused(parameters, "rollover_index_acceleration_weight");
}

TEST(Parameters, TheModelsTimeConstantMustBeAtLeastHalfAStep) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.roll_damping_nmsprad = 0.0049F * parameters.roll_stiffness_nmprad;
    expect_refused(parameters, "roll_damping_nmsprad");
    parameters.roll_damping_nmsprad = 0.0051F * parameters.roll_stiffness_nmprad;
    EXPECT_EQ(rsi::validate(parameters).accepted, 1);
}

TEST(Parameters, TheWarningLevelsMustBeInOrder) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.advisory_off = parameters.advisory_on + 0.01F;
    expect_refused(parameters, "advisory_off");
    parameters = rsi_test::large_suv();
    parameters.warning_off = parameters.warning_on + 0.01F;
    expect_refused(parameters, "warning_off");
    parameters = rsi_test::large_suv();
    parameters.advisory_on = parameters.warning_on + 0.01F;
    expect_refused(parameters, "advisory_on");
    parameters = rsi_test::large_suv();
    parameters.advisory_on = parameters.advisory_off = parameters.warning_off = parameters.warning_on;
    EXPECT_EQ(rsi::validate(parameters).accepted, 1);
}

TEST(Parameters, AWarningLevelThatThePublishedIndicatorCannotReachIsRefused) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.warning_on = 1.01F;
    expect_refused(parameters, "warning_on");
    parameters.warning_indicator = RSI_INDICATOR_BANK_FREE;
    EXPECT_EQ(rsi::validate(parameters).accepted, 1);
}

TEST(Parameters, AWarningLevelThatNoIndicatorReachesBeforeTheLiftIsRefused) {
    for (std::int32_t indicator = 0; indicator < rsi::selection_fields[1].choice_count; ++indicator) {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.warning_indicator = indicator;
        const bool ends_at_one =
            indicator == RSI_INDICATOR_PUBLISHED || indicator == RSI_INDICATOR_LOAD_TRANSFER;
        const float highest = ends_at_one ? 1.0F : 1.2F;
        parameters.warning_on = highest;
        EXPECT_EQ(rsi::validate(parameters).accepted, 1) << indicator;
        parameters.warning_on = std::nextafterf(highest, 2.0F);
        expect_refused(parameters, "warning_on");
        parameters.warning_on = 20.0F;
        expect_refused(parameters, "warning_on");
    }
}

TEST(Parameters, AConfirmationThatSwallowsTheWarningIsRefused) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.warning_confirmation_s = 0.2F;
    EXPECT_EQ(rsi::validate(parameters).accepted, 1);
    parameters.warning_confirmation_s = std::nextafterf(0.2F, 1.0F);
    expect_refused(parameters, "warning_confirmation_s");
}

TEST(Parameters, ARecoveryThatSilencesTheWarningForAManoeuvreIsRefused) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.recovery_s = 2.0F;
    EXPECT_EQ(rsi::validate(parameters).accepted, 1);
    parameters.recovery_s = std::nextafterf(2.0F, 3.0F);
    expect_refused(parameters, "recovery_s");
}

TEST(Parameters, AStiffnessCurveThatFallsTooFarIsRefusedByTheCoefficientThatBendsIt) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.roll_stiffness_cubic_nmprad3 = -1.0e8F;
    expect_refused(parameters, "roll_stiffness_cubic_nmprad3");
    // It rises again before the wheels lift, but has been too low on the way.
    parameters.roll_stiffness_cubic_nmprad3 = -5.0e7F;
    parameters.roll_stiffness_quintic_nmprad5 = 9.9e9F;
    EXPECT_EQ(rsi::validate(parameters).accepted, 1);
    parameters.roll_stiffness_cubic_nmprad3 = -6.0e7F;
    expect_refused(parameters, "roll_stiffness_cubic_nmprad3");
    parameters = rsi_test::large_suv();
    parameters.roll_stiffness_quintic_nmprad5 = -1.0e9F;
    expect_refused(parameters, "roll_stiffness_quintic_nmprad5");
}

TEST(Parameters, LevelsThatTheTimeToRolloverNeverOrAlwaysReachesAreRefused) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.warning_indicator = RSI_INDICATOR_TIME_TO_ROLLOVER;
    EXPECT_EQ(rsi::validate(parameters).accepted, 1);
    parameters.time_to_rollover_limit_s = 0.01F;
    parameters.warning_on = 1.1F;
    expect_refused(parameters, "warning_on");
    parameters.time_to_rollover_limit_s = 5.0F;
    parameters.advisory_off = 0.4F;
    expect_refused(parameters, "advisory_off");
}

// The least stiffness is at the parabola's vertex, phi^2 = -K_2 / (2 K_4), if the wheels lift beyond it; else
// at the angle at which they lift. Therefore a vertex just beyond that angle counts as little as it is
// reached.
TEST(Parameters, AStiffnessThatFallsTooFarOnlyBeyondTheLiftOfTheWheelsIsAccepted) {
    rsi_parameters parameters = rsi_test::large_suv();
    const float critical_rad = rsi::critical_roll_angle_rad(parameters);
    const float furthest = critical_rad * critical_rad;
    const float spare = parameters.roll_stiffness_nmprad -
                        parameters.sprung_mass_kg * 9.80665F *
                            (parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m);
    for (const float beyond : {0.95F, 1.05F}) {  // the vertex over `furthest`
        // Loss of the curve up to the vertex and up to the lift of the wheels, in units of K_4 furthest^2.
        const float at_vertex = beyond * beyond;
        const float at_lift = 2.0F * beyond - 1.0F;
        const float K_4 = 2.0F * spare / ((at_vertex + at_lift) * furthest * furthest);
        parameters.roll_stiffness_quintic_nmprad5 = K_4;
        parameters.roll_stiffness_cubic_nmprad3 = -2.0F * beyond * K_4 * furthest;
        if (beyond < 1.0F) {
            expect_refused(parameters, "roll_stiffness_cubic_nmprad3");
        } else {
            EXPECT_EQ(rsi::validate(parameters).accepted, 1);
        }
    }
}

TEST(Parameters, TheLevelAtRestOfTheTimeToRolloverIsNoOffLevel) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.warning_indicator = RSI_INDICATOR_TIME_TO_ROLLOVER;
    parameters.time_to_rollover_limit_s = 5.0F;
    parameters.advisory_off = 0.1F * 5.0F;
    expect_refused(parameters, "advisory_off");
    parameters.advisory_off = 0.51F;
    EXPECT_EQ(rsi::validate(parameters).accepted, 1);
}

TEST(Parameters, AStiffnessCurveThatOnlyRisesIsAccepted) {
    rsi_parameters parameters = rsi_test::large_suv();
    for (const float cubic : {0.0F, 9.0e7F}) {
        parameters.roll_stiffness_cubic_nmprad3 = cubic;
        for (const float quintic : {0.0F, 1.0e9F}) {
            parameters.roll_stiffness_quintic_nmprad5 = quintic;
            EXPECT_EQ(rsi::validate(parameters).accepted, 1) << cubic << ' ' << quintic;
        }
    }
}

TEST(Parameters, ALevelThatTheTimeToRolloverJustReachesIsAccepted) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.warning_indicator = RSI_INDICATOR_TIME_TO_ROLLOVER;
    parameters.time_to_rollover_limit_s = 0.0101F;
    parameters.warning_on = 1.0F;  // 100 times the limit: 1.01
    EXPECT_EQ(rsi::validate(parameters).accepted, 1);
}

TEST(Parameters, ATrackOfSixTimesTheHeightIsTheWidest) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.sprung_cg_height_m = 0.5F;
    parameters.track_width_m = 3.0F;
    EXPECT_STRNE(rsi::validate(parameters).field, "track_width_m");
    parameters.sprung_cg_height_m = 0.499F;
    expect_refused(parameters, "track_width_m");
}

TEST(Parameters, ARollCentreAHandBelowTheCentreOfGravityIsLowEnough) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.fixed_roll_centre_height_m = parameters.sprung_cg_height_m - 0.0105F;
    EXPECT_STRNE(rsi::validate(parameters).field, "fixed_roll_centre_height_m");
    parameters.fixed_roll_centre_height_m = parameters.sprung_cg_height_m - 0.0095F;
    expect_refused(parameters, "fixed_roll_centre_height_m");
}

TEST(Parameters, ACurveThatOnlyItsQuinticBendsDownIsRefusedByTheQuintic) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.roll_stiffness_cubic_nmprad3 = 0.5F;
    parameters.roll_stiffness_quintic_nmprad5 = -1.0e9F;
    expect_refused(parameters, "roll_stiffness_quintic_nmprad5");
}

}  // namespace
}  // namespace parameters_test
