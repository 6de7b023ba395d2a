// The lateral roll-centre movement (6), the additional roll moment (7) and the model that it compensates.
#include "rsi/estimation/roll_centre.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/recorded_like_signals.hpp"
#include "tests/rsi/support/roll_plane_vehicle.hpp"

namespace roll_centre_test {
namespace {

using rsi_test::Deviation;
using rsi_test::RollPlaneVehicle;

double wide(float value) {
    return static_cast<double>(value);
}

rsi::Measurement measured_at(double parallel, double normal, double angle, double rate) {
    rsi::Measurement measured;
    measured.road_parallel_force_mps2 = static_cast<float>(parallel);
    measured.road_normal_force_mps2 = static_cast<float>(normal);
    measured.roll_angle_rad = static_cast<float>(angle);
    measured.roll_rate_radps = static_cast<float>(rate);
    measured.tan_roll_angle = static_cast<float>(std::tan(angle));
    return measured;
}

rsi::RollCentreEstimate exactly(const Deviation& truth) {
    rsi::RollCentreEstimate estimate;
    estimate.vertical_movement_m = static_cast<float>(truth.vertical_m);
    estimate.stiffness_deviation_nmprad = static_cast<float>(truth.stiffness_nmprad);
    estimate.damping_deviation_nmsprad = static_cast<float>(truth.damping_nmsprad);
    return estimate;
}

class RollCentre : public ::testing::Test {
 protected:
    rsi_parameters parameters{rsi_test::large_suv()};
    const rsi::Vehicle calibrated{parameters};
};

// (6): how far the CG of the fixed-roll-centre vehicle leans out further than that of the measured one.
TEST_F(RollCentre, TheLateralMovementIsTheDifferenceOfTheLeans) {
    const double H = 0.988 - 0.281;
    for (const double phi_f : {-0.12, 0.0, 0.1}) {
        for (const double phi_m : {-0.1, 0.02, 0.13}) {
            for (const double dh : {-0.1, 0.0, 0.06}) {
                rsi::FixedModelRoll fixed;
                fixed.reset(static_cast<float>(phi_f));
                const float c_rc = rsi::lateral_roll_centre_m(calibrated, measured_at(0.0, 9.8, phi_m, 0.0),
                                                              fixed, static_cast<float>(dh));
                EXPECT_NEAR(wide(c_rc), H * std::tan(phi_f) - (H - dh) * std::tan(phi_m), 1.0e-6);
            }
        }
    }
}

// (7) is what must be added to the fixed-roll-centre vehicle's moments, with the gravity term of the
// uncompensated model, to obtain those of the real one: the difference of the right-hand sides of (1) and (2)
// at the measured motion.
TEST_F(RollCentre, TheAdditionalMomentMakesUpTheDifferenceToTheRealVehicle) {
    const Deviation truth{0.06, -5.0e3, 700.0};
    const double m_s = 2060.0;
    const double H = 0.988 - 0.281;
    for (const double A : {-6.0, 2.0, 7.0}) {
        for (const double phi_f : {-0.08, 0.05}) {
            const double N = 9.6;
            const double phi_m = 0.09;
            const RollPlaneVehicle vehicle(parameters, truth);
            const double rate_m = vehicle.rate_radps(A, N, phi_m);
            rsi::FixedModelRoll fixed;
            fixed.reset(static_cast<float>(phi_f));
            const rsi::Measurement measured = measured_at(A, N, phi_m, rate_m);
            const float c_rc =
                rsi::lateral_roll_centre_m(calibrated, measured, fixed, static_cast<float>(truth.vertical_m));
            const double M_add =
                wide(rsi::additional_roll_moment_nm(calibrated, measured, exactly(truth), c_rc));
            const double needed = 8.0e3 * rate_m + 96.0e3 * phi_m - m_s * H * (A + N * std::tan(phi_f));
            EXPECT_NEAR(M_add, needed, 0.05);
        }
    }
}

TEST_F(RollCentre, WithoutDeviationAndWithEqualAnglesNothingIsAdded) {
    rsi::FixedModelRoll fixed;
    fixed.reset(0.08F);
    rsi::Measurement measured = measured_at(5.0, 9.8, 0.08, 0.2);
    measured.tan_roll_angle = rsi::short_range_tangent(0.08F);
    const float c_rc = rsi::lateral_roll_centre_m(calibrated, measured, fixed, 0.0F);
    EXPECT_EQ(c_rc, 0.0F);
    EXPECT_EQ(rsi::additional_roll_moment_nm(calibrated, measured, rsi::RollCentreEstimate{}, c_rc), 0.0F);
}

// -Ixx phi'' of an estimator whose model has an inertia.
TEST_F(RollCentre, TheMomentOfTheInertiaAddsToTheAdditionalMoment) {
    rsi::RollCentreEstimate estimate = exactly(Deviation{0.05, -5.0e3, 600.0});
    const rsi::Measurement measured = measured_at(4.0, 9.5, 0.05, 0.1);
    const float without = rsi::additional_roll_moment_nm(calibrated, measured, estimate, 0.01F);
    estimate.inertia_moment_nm = 250.0F;
    EXPECT_NEAR(rsi::additional_roll_moment_nm(calibrated, measured, estimate, 0.01F), without + 250.0F,
                0.01F);
}

// Fig. 7 with the exact theta in place of the estimate. Half a sample of delay would be up to 0.2 rad/s * 5
// ms, ten times what is allowed.
TEST_F(RollCentre, WithTheExactParametersTheCompensatedModelFollowsTheVehicle) {
    const Deviation truth{0.08, -8.0e3, 900.0};
    RollPlaneVehicle vehicle(parameters, truth);
    rsi::FixedModelRoll fixed;
    rsi::CompensatedModelRoll compensated;
    fixed.reset(0.0F);
    compensated.reset(0.0F);
    double worst_compensated = 0.0;
    double worst_fixed = 0.0;
    for (int k = 0; k < 3000; ++k) {
        const double A = rsi_test::lively_lateral_acceleration_mps2(0.01 * k);
        const double N = rsi_test::gravity_mps2;
        const double phi_m = vehicle.angle_rad();
        const rsi::Measurement measured = measured_at(A, N, phi_m, vehicle.rate_radps(A, N, phi_m));
        fixed.update(calibrated, measured);
        const float c_rc =
            rsi::lateral_roll_centre_m(calibrated, measured, fixed, static_cast<float>(truth.vertical_m));
        const float M_add = rsi::additional_roll_moment_nm(calibrated, measured, exactly(truth), c_rc);
        compensated.update(calibrated, measured, fixed, M_add);
        if (k >= 100) {  // ten time constants after the start
            worst_compensated =
                std::fmax(worst_compensated, std::fabs(wide(compensated.angle_rad()) - phi_m));
            worst_fixed = std::fmax(worst_fixed, std::fabs(wide(fixed.angle_rad()) - phi_m));
        }
        vehicle.advance_under(
            [k](double t) { return rsi_test::lively_lateral_acceleration_mps2(0.01 * k + t); },
            [](double) { return rsi_test::gravity_mps2; }, 0.01);
    }
    EXPECT_LT(worst_compensated, 1.0e-4);
    EXPECT_GT(worst_fixed, 50.0 * worst_compensated);
}

}  // namespace
}  // namespace roll_centre_test
