// The regression (4), (5): its identity on any data, and its signs on a vehicle that obeys (2).
#include "rsi/estimation/regression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/roll_plane_vehicle.hpp"

namespace regression_test {
namespace {

using rsi_test::Deviation;
using rsi_test::RollPlaneVehicle;

double wide(float value) {
    return static_cast<double>(value);
}

// The term that (4) drops from (3) by writing phi_f - phi_m for the difference of the tangents.
double small_angle_remainder_nm(const rsi::Vehicle& calibrated, double normal_force_n, double phi_f,
                                double phi_m) {
    return normal_force_n * wide(calibrated.loaded.body.roll_arm_m) *
           ((std::tan(phi_f) - phi_f) - (std::tan(phi_m) - phi_m));
}

// Y is the difference of moments up to 7e4 N m, each rounded to a float (6e-8) a few times.
constexpr double moment_tolerance_nm = 0.05;

struct Sample {
    rsi::Measurement measured;
    rsi::FixedModelRoll fixed;
};

Sample sample(const rsi::Vehicle& calibrated, float parallel, float normal, float phi_f, float phi_m,
              float rate_m) {
    Sample result;
    result.measured.road_parallel_force_mps2 = parallel;
    result.measured.road_normal_force_mps2 = normal;
    result.measured.roll_angle_rad = phi_m;
    result.measured.roll_rate_radps = rate_m;
    result.measured.tan_roll_angle = rsi::bounded_tangent(phi_m);
    result.fixed.reset(phi_f);
    result.fixed.update(calibrated, result.measured);
    return result;
}

// Structural singularity: whatever the vehicle does, theta = [H, -K_f, -c_f] explains Y.
TEST(Regression, AnyDataFitTheTrivialSolution) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const rsi::Vehicle calibrated{parameters};
    std::mt19937 random(11U);
    std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
    for (int trial = 0; trial < 20000; ++trial) {
        const float phi_f = 0.3F * unit(random);
        const Sample at = sample(calibrated, 10.0F * unit(random), 9.8F + 3.0F * unit(random), phi_f,
                                 0.3F * unit(random), unit(random));
        const rsi::Regression regression = rsi::regress(calibrated, at.measured, at.fixed);
        const double trivial = wide(calibrated.loaded.body.roll_arm_m) * wide(regression.psi.x()) -
                               wide(calibrated.suspension.stiffness_nmprad) * wide(regression.psi.y()) -
                               wide(calibrated.suspension.damping_nmsprad) * wide(regression.psi.z());
        const double N_force =
            wide(calibrated.loaded.body.mass_kg) * wide(at.measured.road_normal_force_mps2);
        const double remainder =
            small_angle_remainder_nm(calibrated, N_force, wide(phi_f), wide(at.measured.roll_angle_rad));
        ASSERT_NEAR(wide(regression.output_nm), trivial + remainder, moment_tolerance_nm);
    }
}

// At 6 degrees, where the paper's turns lie, the remainder is a few N m in a Y of hundreds.
TEST(Regression, TheTrivialSolutionsRemainderIsSmall) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const rsi::Vehicle calibrated{parameters};
    EXPECT_LT(std::fabs(small_angle_remainder_nm(calibrated, 2060.0 * 9.80665, 0.105, 0.095)), 3.0);
}

// (2) turned into (4): for a vehicle with known dh, dK, dc, Y = psi^T theta but for the tangents' remainder.
TEST(Regression, AVehicleThatObeysEquationTwoSatisfiesTheRegression) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const rsi::Vehicle calibrated{parameters};
    for (const Deviation& truth : {Deviation{0.08, 0.0, 0.0}, Deviation{0.0, 9.0e3, 0.0},
                                   Deviation{0.0, 0.0, -1.5e3}, Deviation{-0.06, -7.0e3, 900.0}}) {
        const RollPlaneVehicle vehicle(parameters, truth);
        for (const float parallel : {-7.0F, -2.0F, 0.0F, 3.0F, 8.0F}) {
            for (const float phi_m : {-0.12F, -0.02F, 0.05F, 0.11F}) {
                const float normal = 9.5F;
                const float phi_f = 0.8F * phi_m + 0.01F;
                const float rate_m =
                    static_cast<float>(vehicle.rate_radps(wide(parallel), wide(normal), wide(phi_m)));
                const Sample at = sample(calibrated, parallel, normal, phi_f, phi_m, rate_m);
                const rsi::Regression regression = rsi::regress(calibrated, at.measured, at.fixed);
                const double explained = truth.vertical_m * wide(regression.psi.x()) +
                                         truth.stiffness_nmprad * wide(regression.psi.y()) +
                                         truth.damping_nmsprad * wide(regression.psi.z());
                const double remainder =
                    small_angle_remainder_nm(calibrated, 2060.0 * wide(normal), wide(phi_f), wide(phi_m));
                EXPECT_NEAR(wide(regression.output_nm), explained + remainder, moment_tolerance_nm);
            }
        }
    }
}

TEST(Regression, TheRegressorHoldsForceAngleAndRateOfTheMeasuredVehicle) {
    const rsi::Vehicle calibrated{rsi_test::large_suv()};
    const Sample at = sample(calibrated, 4.0F, 9.0F, 0.0F, 0.1F, -0.3F);
    const rsi::Regression regression = rsi::regress(calibrated, at.measured, at.fixed);
    EXPECT_NEAR(wide(regression.psi.x()), 2060.0 * (4.0 + 9.0 * std::tan(0.1)), 0.01);
    EXPECT_EQ(regression.psi.y(), 0.1F);
    EXPECT_EQ(regression.psi.z(), -0.3F);
}

}  // namespace
}  // namespace regression_test
