// Roll stiffness curve: powers of the roll angle as far as they are plausible, then a straight line.
#include "rsi/model/roll_stiffness_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/rsi/support/nominal.hpp"

namespace roll_stiffness_curve_test {
namespace {

rsi::Parameters with(float cubic, float quintic) {
    rsi::Parameters parameters = rsi_test::large_suv();
    parameters.roll_stiffness_nmprad = 80.0e3F;
    parameters.roll_stiffness_cubic_nmprad3 = cubic;
    parameters.roll_stiffness_quintic_nmprad5 = quintic;
    return parameters;
}

rsi::RollStiffnessCurve curve_of(const rsi::Parameters& parameters, float factor = 1.0F) {
    return rsi::RollStiffnessCurve{parameters, factor};
}

float by_powers_nm(const rsi::Parameters& p, float angle_rad) {
    const float z = angle_rad * angle_rad;
    return angle_rad * (p.roll_stiffness_nmprad +
                        z * (p.roll_stiffness_cubic_nmprad3 + z * p.roll_stiffness_quintic_nmprad5));
}

float slope_by_powers_nmprad(const rsi::Parameters& p, float angle_rad) {
    const float z = angle_rad * angle_rad;
    return p.roll_stiffness_nmprad +
           z * (3.0F * p.roll_stiffness_cubic_nmprad3 + z * 5.0F * p.roll_stiffness_quintic_nmprad5);
}

TEST(RollStiffnessCurve, IsThatOfThePowersWhereTheyRise) {
    for (const rsi::Parameters& p :
         {with(0.0F, 0.0F), with(2.0e6F, 0.0F), with(1.0e6F, 3.0e7F), with(-1.0e6F, 9.0e7F)}) {
        const rsi::RollStiffnessCurve curve = curve_of(p);
        for (float angle = -0.6F; angle <= 0.6F; angle += 0.05F) {
            EXPECT_FLOAT_EQ(curve.moment_nm(angle), by_powers_nm(p, angle)) << angle;
            EXPECT_FLOAT_EQ(curve.slope_nmprad(angle), slope_by_powers_nmprad(p, angle)) << angle;
        }
    }
}

// Angle at which the slope is a quarter of K_f: 3 K_2 z + 5 K_4 z^2 = -0.75 K_f.
TEST(RollStiffnessCurve, GoesStraightOnWhereThePowersHaveFallenToAQuarterOfTheFirstSlope) {
    struct Case {
        float cubic;
        float quintic;
        float end_rad;
    };
    for (const Case& tested : {Case{-2.0e6F, 0.0F, 0.1F}, Case{0.0F, -1.2e8F, 0.1F},
                               Case{1.0e6F, -1.8e8F, 0.1F}, Case{-4.0e6F, 1.0e8F, 0.0842671F}}) {
        const rsi::Parameters p = with(tested.cubic, tested.quintic);
        const rsi::RollStiffnessCurve curve = curve_of(p);
        const float end = tested.end_rad;
        EXPECT_NEAR(slope_by_powers_nmprad(p, end), 20.0e3F, 20.0F);
        for (const float side : {-1.0F, 1.0F}) {
            EXPECT_FLOAT_EQ(curve.moment_nm(side * 0.99F * end), by_powers_nm(p, side * 0.99F * end));
            EXPECT_NEAR(curve.moment_nm(side * 2.0F * end), side * (by_powers_nm(p, end) + 20.0e3F * end),
                        2.0F);
            EXPECT_NEAR(curve.slope_nmprad(side * 2.0F * end), 20.0e3F, 20.0F);
            EXPECT_NEAR(curve.moment_nm(side * 1.2F),
                        1.2F * (p.roll_stiffness_nmprad + curve.secant_deviation_nmprad(side * 1.2F)) * side,
                        0.1F);
        }
    }
}

// By hand: the powers up to there, then the slope that they have there.
TEST(RollStiffnessCurve, GoesStraightOnFrom1500MilliradiansAtTheLatest) {
    EXPECT_NEAR(curve_of(with(40.0e3F, 0.0F)).moment_nm(2.0F), 255.0e3F + 0.5F * 350.0e3F, 1.0F);
    // 3 K_2 z = -0.75 K_f at 1.45 rad; at 1.55 rad it would be too far.
    const float soon = -20.0e3F / (1.45F * 1.45F);
    EXPECT_NEAR(curve_of(with(soon, 0.0F)).moment_nm(2.0F), 87.0e3F + 0.55F * 20.0e3F, 1.0F);
    const float late = -20.0e3F / (1.55F * 1.55F);
    EXPECT_NEAR(curve_of(with(late, 0.0F)).moment_nm(2.0F), 91904.3F + 0.5F * 23808.5F, 1.0F);
}

TEST(RollStiffnessCurve, EndsAtTheSameAngleWhateverItIsMultipliedBy) {
    const rsi::Parameters p = with(0.0F, -1.2e8F);
    const rsi::RollStiffnessCurve curve = curve_of(p);
    const rsi::RollStiffnessCurve scaled = curve_of(p, 1.0F / 512.0F);
    for (const float angle : {0.05F, 0.11F, 0.3F, 1.0F}) {
        EXPECT_EQ(scaled.moment_nm(angle), curve.moment_nm(angle) / 512.0F);
    }
}

// The largest numbers of the parameters' table.
TEST(RollStiffnessCurve, IsFiniteForEveryCoefficientThatIsAdmitted) {
    for (const float cubic : {-1.0e8F, 0.0F, 1.0e8F}) {
        for (const float quintic : {-1.0e10F, 0.0F, 1.0e10F}) {
            const rsi::RollStiffnessCurve curve = curve_of(with(cubic, quintic));
            for (const float angle : {1.0e-6F, 0.2F, 1.0F, 3.0F}) {
                EXPECT_TRUE(std::isfinite(curve.moment_nm(angle)));
                EXPECT_TRUE(std::isfinite(curve.secant_deviation_nmprad(angle)));
            }
        }
    }
}

}  // namespace
}  // namespace roll_stiffness_curve_test
