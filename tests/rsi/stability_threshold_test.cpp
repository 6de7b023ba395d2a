// The threshold (23) against the moment balance (12) to (20), solved by bisection in double.
#include "rsi/indicator/stability_threshold.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rsi/indicator/roll_stability_indicator.hpp"
#include "tests/rsi/support/body_kinematics.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/stages.hpp"

namespace stability_threshold_test {
namespace {

using rsi_test::GroundMotion;
using rsi_test::PlaneVector;

double wide(float value) {
    return static_cast<double>(value);
}

constexpr double track_m = 1.6;
constexpr double height_m = 0.988;
constexpr double fixed_roll_centre_m = 0.281;
constexpr double mass_kg = 2060.0;

struct RollCentrePosition {
    double vertical_m;  // dh
    double lateral_m;   // c_rc, > 0 towards the side to which the CG moves for phi > 0 (right)
};

enum class Turn { left, right };

// Load of the inner wheels from (12) to (20): forces through the roll centre, the suspension's moment K phi
// from the body's balance (19), moments about the outer wheels' contact. A right turn is a left turn seen in
// a mirror.
double inner_load_n(const GroundMotion& motion, const RollCentrePosition& at, Turn turn) {
    const PlaneVector force = rsi_test::specific_force_along(motion, motion.bank_angle_rad);
    const double mirror = (turn == Turn::left) ? 1.0 : -1.0;
    const double A = mirror * force.left;
    const double N = force.up;
    const double phi = mirror * motion.roll_angle_rad;
    const double c = mirror * at.lateral_m;
    const double h_rc = fixed_roll_centre_m + at.vertical_m;
    const double F_y = mass_kg * A;
    const double F_z = mass_kg * N;
    const double K_phi = mass_kg * (height_m - h_rc) * (A + N * std::tan(phi));  // (19)
    return (F_z * (0.5 * track_m - c) - F_y * h_rc - K_phi) / track_m;           // (15)
}

// The same from statics alone, without a roll centre in the balance: a point mass at height h, displaced to
// the right by c + (h - h_rc) tan phi, on two contacts.
double inner_load_of_point_mass_n(const GroundMotion& motion, const RollCentrePosition& at, Turn turn) {
    const PlaneVector force = rsi_test::specific_force_along(motion, motion.bank_angle_rad);
    const double h_rc = fixed_roll_centre_m + at.vertical_m;
    const double right_m = at.lateral_m + (height_m - h_rc) * std::tan(motion.roll_angle_rad);
    const double transfer = mass_kg * (force.left * height_m + force.up * right_m) / track_m;
    return 0.5 * mass_kg * force.up + ((turn == Turn::left) ? -transfer : transfer);
}

// The lateral acceleration at which the inner wheels lift.
template <typename Load>
double lifting_acceleration(Load load, GroundMotion motion, const RollCentrePosition& at, Turn turn) {
    double loaded = 0.0;
    double lifted = (turn == Turn::left) ? 30.0 : -30.0;
    for (int halving = 0; halving < 80; ++halving) {
        motion.lateral_acceleration_mps2 = 0.5 * (loaded + lifted);
        ((load(motion, at, turn) > 0.0) ? loaded : lifted) = motion.lateral_acceleration_mps2;
    }
    return 0.5 * (loaded + lifted);
}

// A measurement whose A has the sign of the turn; its size plays no part in the threshold.
rsi::Measurement in_turn(const GroundMotion& motion, Turn turn) {
    rsi::Measurement measured;
    measured.road_parallel_force_mps2 = (turn == Turn::left) ? 4.0F : -4.0F;
    measured.road_normal_force_mps2 = 9.8F;
    measured.roll_angle_rad = static_cast<float>(motion.roll_angle_rad);
    measured.tan_roll_angle = static_cast<float>(std::tan(motion.roll_angle_rad));
    measured.tan_bank_angle = static_cast<float>(std::tan(motion.bank_angle_rad));
    return measured;
}

rsi::Vehicle suv() {
    return rsi::Vehicle{rsi_test::large_suv()};
}

template <typename Check>
void for_each_case(Check check) {
    for (const Turn turn : {Turn::left, Turn::right}) {
        for (const double bank : {-0.3, -0.15, 0.0, 0.08, 0.3}) {
            for (const double roll : {-0.12, -0.03, 0.0, 0.06, 0.11}) {
                for (const RollCentrePosition at :
                     {RollCentrePosition{0.0, 0.0}, RollCentrePosition{0.1, 0.03},
                      RollCentrePosition{-0.08, -0.05}, RollCentrePosition{0.05, -0.1}}) {
                    check(GroundMotion{0.0, 0.0, bank, roll}, at, turn);
                }
            }
        }
    }
}

TEST(StabilityThreshold, IsTheAccelerationAtWhichTheInnerWheelsLift) {
    for_each_case([&](const GroundMotion& motion, const RollCentrePosition& at, Turn turn) {
        const rsi::StabilityThreshold answer =
            rsi::stability_threshold(suv(), in_turn(motion, turn), static_cast<float>(at.vertical_m),
                                     static_cast<float>(at.lateral_m));
        EXPECT_NEAR(wide(answer.lateral_acceleration_mps2),
                    lifting_acceleration(inner_load_n, motion, at, turn), 2.0e-5)
            << "bank " << motion.bank_angle_rad << ", roll " << motion.roll_angle_rad;
        EXPECT_EQ(answer.side, (turn == Turn::left) ? 1.0F : -1.0F);
    });
}

TEST(StabilityThreshold, AgreesWithThePlainStaticsOfTwoContacts) {
    for_each_case([&](const GroundMotion& motion, const RollCentrePosition& at, Turn turn) {
        const rsi::StabilityThreshold answer =
            rsi::stability_threshold(suv(), in_turn(motion, turn), static_cast<float>(at.vertical_m),
                                     static_cast<float>(at.lateral_m));
        EXPECT_NEAR(wide(answer.lateral_acceleration_mps2),
                    lifting_acceleration(inner_load_of_point_mass_n, motion, at, turn), 2.0e-5);
    });
}

// On a flat road and without roll only track width and height of the CG remain: the static stability factor.
TEST(StabilityThreshold, IsTheStaticStabilityFactorWithoutRollOnAFlatRoad) {
    const double ssf = track_m / (2.0 * height_m);
    for (const Turn turn : {Turn::left, Turn::right}) {
        const rsi::StabilityThreshold answer =
            rsi::stability_threshold(suv(), in_turn(GroundMotion{}, turn), 0.07F, 0.0F);
        EXPECT_NEAR(std::fabs(wide(answer.lateral_acceleration_mps2)), ssf * rsi_test::gravity_mps2, 1.0e-5);
        EXPECT_NEAR(wide(answer.half_track_ratio), ssf, 1.0e-6);
    }
}

TEST(StabilityThreshold, StaysAwayFromZeroWhereTheBankAloneOverturns) {
    for (const Turn turn : {Turn::left, Turn::right}) {
        const double unfavourable = (turn == Turn::left) ? 0.8 : -0.8;
        const rsi::StabilityThreshold answer = rsi::stability_threshold(
            suv(), in_turn(GroundMotion{0.0, 0.0, unfavourable, 0.0}, turn), 0.0F, 0.0F);
        EXPECT_NEAR(wide(answer.lateral_acceleration_mps2 * answer.side), 0.05 * rsi_test::gravity_mps2,
                    1.0e-6);
    }
}

TEST(StabilityThreshold, StaysFiniteAndOnItsSideWhereNoAccelerationOverturns) {
    rsi_parameters low = rsi_test::large_suv();
    low.sprung_cg_height_m = 0.4F;  // T = 2: with tan 0.8 = 1.03 the divisor 1 - e T is negative
    const rsi::Vehicle vehicle{low};
    for (const Turn turn : {Turn::left, Turn::right}) {
        const double favourable = (turn == Turn::left) ? -0.8 : 0.8;
        const rsi::StabilityThreshold answer = rsi::stability_threshold(
            vehicle, in_turn(GroundMotion{0.0, 0.0, favourable, 0.0}, turn), 0.0F, 0.0F);
        EXPECT_GT(answer.lateral_acceleration_mps2 * answer.side, 20.0F * 9.8F);
        EXPECT_TRUE(std::isfinite(answer.lateral_acceleration_mps2));
    }
}

TEST(StabilityThreshold, TheHalfTrackRatioNeverFallsBelowOneTwentieth) {
    const rsi::StabilityThreshold answer =
        rsi::stability_threshold(suv(), in_turn(GroundMotion{0.0, 0.0, 0.0, 0.6}, Turn::left), 0.0F, 0.9F);
    EXPECT_EQ(answer.half_track_ratio, 0.05F);
    EXPECT_GT(answer.lateral_acceleration_mps2, 0.0F);
}

// (25) and its bank-free form.

rsi::Measurement measured(const GroundMotion& motion) {
    rsi_test::MeasurementStage measurement;
    measurement.init(rsi_test::large_suv());
    rsi::Measurement result;
    EXPECT_TRUE(measurement.update(rsi_test::sensed(motion), result));
    return result;
}

TEST(RollStabilityIndicator, BothFormsReachOneExactlyWhenTheInnerWheelsLift) {
    for_each_case([](GroundMotion motion, const RollCentrePosition& at, Turn turn) {
        motion.lateral_acceleration_mps2 = lifting_acceleration(inner_load_n, motion, at, turn);
        const rsi::Measurement now = measured(motion);
        const rsi::StabilityThreshold threshold = rsi::stability_threshold(
            suv(), now, static_cast<float>(at.vertical_m), static_cast<float>(at.lateral_m));
        EXPECT_NEAR(wide(rsi::normalised_indicator(now, threshold)), 1.0, 2.0e-5);
        EXPECT_NEAR(wide(rsi::bank_free_indicator(now, threshold)), 1.0, 2.0e-5);
    });
}

TEST(RollStabilityIndicator, IsTheShareOfTheThresholdThatIsUsed) {
    GroundMotion motion{0.0, 0.0, 0.0, 0.05};
    const RollCentrePosition at{0.0, 0.0};
    const double lifting = lifting_acceleration(inner_load_n, motion, at, Turn::left);
    for (const double share : {0.1, 0.5, 0.9}) {
        motion.lateral_acceleration_mps2 = share * lifting;
        const rsi::Measurement now = measured(motion);
        const rsi::StabilityThreshold threshold = rsi::stability_threshold(suv(), now, 0.0F, 0.0F);
        EXPECT_NEAR(wide(rsi::normalised_indicator(now, threshold)), share, 1.0e-5);
        EXPECT_NEAR(wide(rsi::bank_free_indicator(now, threshold)), share, 1.0e-5);
    }
}

TEST(RollStabilityIndicator, ThePublishedFormEndsAtOneAndTheBankFreeOneGoesOn) {
    const rsi::Measurement now = measured(GroundMotion{15.0, 0.0, 0.0, 0.0});
    const rsi::StabilityThreshold threshold = rsi::stability_threshold(suv(), now, 0.0F, 0.0F);
    EXPECT_EQ(rsi::normalised_indicator(now, threshold), 1.0F);
    EXPECT_NEAR(wide(rsi::bank_free_indicator(now, threshold)), 15.0 / rsi_test::gravity_mps2 / 0.809717,
                1.0e-4);
}

// A slow left turn on a road that falls away to the left further than the turn needs: a_y points left, but
// the vehicle leans on its left wheels as in a right turn.
TEST(RollStabilityIndicator, ThePublishedFormIsZeroWhereTheTurnRelievesTheBank) {
    const rsi::Measurement now = measured(GroundMotion{1.0, 0.0, -0.3, 0.0});
    ASSERT_GT(now.lateral_acceleration_mps2, 0.0F);
    ASSERT_LT(now.road_parallel_force_mps2, 0.0F);
    const rsi::StabilityThreshold threshold = rsi::stability_threshold(suv(), now, 0.0F, 0.0F);
    EXPECT_EQ(threshold.side, -1.0F);
    EXPECT_EQ(rsi::normalised_indicator(now, threshold), 0.0F);
    EXPECT_GT(rsi::bank_free_indicator(now, threshold), 0.1F);
}

TEST(RollStabilityIndicator, TheBankFreeFormNeedsNoBankAngle) {
    rsi_inputs inputs = rsi_test::sensed(GroundMotion{5.0, 0.0, 0.2, 0.05});
    rsi_test::MeasurementStage measurement;
    measurement.init(rsi_test::large_suv());
    rsi::Measurement with_bank;
    rsi::Measurement without_bank;
    ASSERT_TRUE(measurement.update(inputs, with_bank));
    inputs.bank_angle_rad = std::nanf("");
    ASSERT_TRUE(measurement.update(inputs, without_bank));
    EXPECT_EQ(
        rsi::bank_free_indicator(with_bank, rsi::stability_threshold(suv(), with_bank, 0.02F, 0.01F)),
        rsi::bank_free_indicator(without_bank, rsi::stability_threshold(suv(), without_bank, 0.02F, 0.01F)));
}

TEST(RollStabilityIndicator, AVehicleHasOverturnedWhenItsCentreOfGravityStandsOutsideTheContact) {
    const double tipping = std::atan(track_m / (2.0 * height_m));
    const auto factor = static_cast<float>(track_m / (2.0 * height_m));
    for (const double sign : {-1.0, 1.0}) {
        EXPECT_FALSE(
            rsi::has_overturned(measured(GroundMotion{0.0, 0.0, 0.0, sign * (tipping - 1.0e-4)}), factor));
        EXPECT_TRUE(
            rsi::has_overturned(measured(GroundMotion{0.0, 0.0, 0.0, sign * (tipping + 1.0e-4)}), factor));
        rsi_inputs on_its_side = rsi_test::at_rest();
        on_its_side.roll_angle_rad = static_cast<float>(sign * 2.2);
        rsi_test::MeasurementStage measurement;
        measurement.init(rsi_test::large_suv());
        rsi::Measurement now;
        ASSERT_TRUE(measurement.update(on_its_side, now));
        EXPECT_TRUE(rsi::has_overturned(now, factor));
    }
}

TEST(RollStabilityIndicator, AVehicleHasOverturnedAtTheStaticStabilityFactorItself) {
    rsi::Measurement measured;
    for (const float side : {1.0F, -1.0F}) {
        measured.tan_roll_angle = side * 0.8F;
        EXPECT_TRUE(rsi::has_overturned(measured, 0.8F));
        EXPECT_FALSE(rsi::has_overturned(measured, 0.801F));
    }
}

TEST(RollStabilityIndicator, TheBankFreeFormEndsAtTwenty) {
    rsi::Measurement measured;
    measured.road_normal_force_mps2 = 1.0F;
    rsi::StabilityThreshold threshold;
    threshold.half_track_ratio = 0.5F;
    for (const float side : {1.0F, -1.0F}) {
        measured.road_parallel_force_mps2 = side * 9.5F;
        EXPECT_FLOAT_EQ(rsi::bank_free_indicator(measured, threshold), 19.0F);
        measured.road_parallel_force_mps2 = side * 60.0F;
        EXPECT_EQ(rsi::bank_free_indicator(measured, threshold), 20.0F);
    }
}

// 1 + s T tan b stays at least 0.05 on a bank so steep that no acceleration overturns.
TEST(StabilityThreshold, DividesByATwentiethAtLeast) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.track_width_m = 1.9F;
    parameters.sprung_cg_height_m = 1.0F;
    const rsi::Vehicle vehicle{parameters};
    rsi::Measurement measured;
    measured.road_parallel_force_mps2 = 1.0F;
    measured.tan_bank_angle = -1.03F;
    EXPECT_NEAR(static_cast<double>(
                    rsi::stability_threshold(vehicle, measured, 0.0F, 0.0F).lateral_acceleration_mps2),
                9.80665 * (0.95 + 1.03) / 0.05, 0.05);
}

}  // namespace
}  // namespace stability_threshold_test
