// Tyre: its forces against the formulas that define it.
#include <gtest/gtest.h>
#include <cmath>

#include "scenario.hpp"
#include "sil/world/vehicle/tyre.hpp"
#include "sil/world/vehicle/wheel_contact.hpp"

namespace {

class TyreTest : public testing::Test {
 protected:
    sil::TyreParameters parameters_{scenario::large_suv().tyre};
    sil::Tyre tyre_{parameters_, 0.9};

    double friction(double load_n) const {
        return parameters_.friction * 0.9 *
               (1.0 - parameters_.friction_load_sensitivity * (load_n / 6000.0 - 1.0));
    }
};

TEST_F(TyreTest, NeverPullsTheWheelDown) {
    EXPECT_EQ(tyre_.vertical_force_n(-0.001, 5.0), 0.0);
    EXPECT_EQ(tyre_.vertical_force_n(0.0, 5.0), 0.0);
    EXPECT_EQ(tyre_.vertical_force_n(0.001, -10.0), 0.0);
    EXPECT_NEAR(tyre_.vertical_force_n(0.02, 0.0), 0.02 * parameters_.vertical_stiffness_npm, 1e-9);
}

TEST_F(TyreTest, HasItsCorneringStiffnessAtSmallSlip) {
    for (const double load_n : {2000.0, 6000.0, 11000.0}) {
        const double expected = parameters_.cornering_stiffness_nprad *
                                std::sin(2.0 * std::atan(load_n / parameters_.cornering_stiffness_load_n));
        const double slip = 1e-4;
        EXPECT_NEAR(tyre_.forces({0.0, slip}, load_n, 1.0, 0.0).lateral_n / slip, expected, 1e-3 * expected);
        EXPECT_NEAR(tyre_.forces({slip, 0.0}, load_n, 1.0, 0.0).longitudinal_n / slip,
                    parameters_.slip_stiffness_ratio * expected, 2e-3 * expected);
    }
}

TEST_F(TyreTest, PeaksAtFrictionTimesLoadWhichFallsWithLoad) {
    for (const double load_n : {3000.0, 6000.0, 10000.0}) {
        double peak = 0.0;
        for (double slip = 0.0; slip < 1.0; slip += 0.001) {
            peak = std::max(peak, tyre_.forces({0.0, slip}, load_n, 1.0, 0.0).lateral_n);
        }
        EXPECT_NEAR(peak, friction(load_n) * load_n, 1e-4 * load_n);
    }
    EXPECT_LT(friction(10000.0), friction(3000.0));
}

TEST_F(TyreTest, StaysWithinTheFrictionEllipseUnderCombinedSlip) {
    const double load_n = 6000.0;
    for (double longitudinal = -1.0; longitudinal <= 1.0; longitudinal += 0.05) {
        for (double lateral = -1.0; lateral <= 1.0; lateral += 0.05) {
            const sil::TyreForces force = tyre_.forces({longitudinal, lateral}, load_n, 1.0, 0.0);
            ASSERT_LE(std::hypot(force.longitudinal_n, force.lateral_n),
                      friction(load_n) * load_n * 1.000001);
            ASSERT_GE(force.longitudinal_n * longitudinal, 0.0);
            ASSERT_GE(force.lateral_n * lateral, 0.0);
        }
    }
    EXPECT_LT(tyre_.forces({0.1, 0.1}, load_n, 1.0, 0.0).lateral_n,
              tyre_.forces({0.0, 0.1}, load_n, 1.0, 0.0).lateral_n);
}

TEST_F(TyreTest, GivesNoForceInTheAirOrOnARoadWithoutFriction) {
    EXPECT_EQ(tyre_.forces({0.1, 0.1}, 0.0, 1.0, 0.0).lateral_n, 0.0);
    EXPECT_EQ(tyre_.forces({0.0, 0.0}, 6000.0, 1.0, 0.0).lateral_n, 0.0);
}

TEST_F(TyreTest, ReachesNearlyTwoThirdsOfASideslipStepWithinItsRelaxationLength) {
    sil::TyreSlip slip;
    const double speed_mps = 20.0;
    const double step_s = 1e-4;
    double travelled_m = 0.0;
    while (travelled_m < parameters_.relaxation_length_m) {
        tyre_.advance(slip, speed_mps, 0.0, -1.0, step_s);
        travelled_m += speed_mps * step_s;
    }
    EXPECT_NEAR(slip.lateral, (1.0 - std::exp(-1.0)) / speed_mps, 0.0002);
}

TEST_F(TyreTest, LeaningToTheRightPushesToTheRightWithCamberThrust) {
    sil::TyreParameters parameters = parameters_;
    parameters.camber_thrust_prad = 0.6;
    const sil::Tyre tyre{parameters, 0.9};
    const double load_n = 5000.0;
    EXPECT_NEAR(tyre.forces({}, load_n, 1.0, 0.02).lateral_n, -0.6 * load_n * 0.02, 1.0);
}

TEST(WheelContact, OfAnUprightWheelIsBelowItsCentreAtTheLoadedRadius) {
    const sil::WheelContact contact =
        sil::find_wheel_contact<double>(sil::Vector3::UnitY(), sil::Vector3::UnitZ(), 0.38, 0.40);
    EXPECT_NEAR(contact.deflection_m, 0.02, 1e-12);
    EXPECT_NEAR((contact.arm - sil::Vector3{0.0, 0.0, -0.38}).norm(), 0.0, 1e-12);
    EXPECT_NEAR((contact.forward - sil::Vector3::UnitX()).norm(), 0.0, 1e-12);
    EXPECT_NEAR((contact.left - sil::Vector3::UnitY()).norm(), 0.0, 1e-12);
}

TEST(WheelContact, OfALeaningWheelMovesTowardsTheLeanAndTheRadiusShortens) {
    const double camber = 0.1;  // top to the right
    const sil::Vector3 axis{0.0, std::cos(camber), std::sin(camber)};
    const sil::WheelContact contact = sil::find_wheel_contact<double>(axis, sil::Vector3::UnitZ(), 0.5, 0.40);
    EXPECT_NEAR(contact.deflection_m, 0.40 * std::cos(camber) - 0.5, 1e-12);
    EXPECT_GT(contact.arm.y(), 0.0) << "the top leans to the right, so the bottom is to the left";
    EXPECT_NEAR(contact.arm.dot(axis), 0.0, 1e-12);
    EXPECT_NEAR(contact.camber, std::sin(camber), 1e-12);
}

}  // namespace
