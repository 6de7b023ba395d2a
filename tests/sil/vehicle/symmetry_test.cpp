// Symmetry: a turn to the right is the mirror image of a turn to the left.
#include <gtest/gtest.h>
#include <cmath>

#include "scenario.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/mirror.hpp"

namespace {

void expect_equal(const sil::Truth& a, const sil::Truth& b, double tolerance) {
    ASSERT_NEAR(a.steering_wheel_angle_rad, b.steering_wheel_angle_rad, tolerance);
    ASSERT_NEAR(a.position_y_m, b.position_y_m, tolerance);
    ASSERT_NEAR(a.yaw_angle_rad, b.yaw_angle_rad, tolerance);
    ASSERT_NEAR(a.roll_angle_rad, b.roll_angle_rad, tolerance);
    ASSERT_NEAR(a.bank_angle_rad, b.bank_angle_rad, tolerance);
    ASSERT_NEAR(a.lateral_acceleration_mps2, b.lateral_acceleration_mps2, tolerance);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_NEAR(a.angular_velocity_radps[axis], b.angular_velocity_radps[axis], tolerance);
        ASSERT_NEAR(a.angular_acceleration_radps2[axis], b.angular_acceleration_radps2[axis],
                    1e3 * tolerance);
        ASSERT_NEAR(a.specific_force_mps2[axis], b.specific_force_mps2[axis], tolerance);
    }
    for (std::size_t wheel = 0; wheel < sil::wheel_count; ++wheel) {
        ASSERT_NEAR(a.wheel_load_n[wheel], b.wheel_load_n[wheel], 1e4 * tolerance);
        ASSERT_NEAR(a.suspension_deflection_m[wheel], b.suspension_deflection_m[wheel], tolerance);
        ASSERT_NEAR(a.wheel_gap_m[wheel], b.wheel_gap_m[wheel], tolerance);
    }
}

void expect_mirror_image(const sil::Manoeuvre& manoeuvre, double until_s) {
    const sil::VehicleParameters parameters = scenario::symmetric(scenario::large_suv());
    sil::RunOptions options;
    options.duration_s = until_s;
    sil::ManoeuvreRun left{parameters, manoeuvre, options};
    options.mirrored = true;
    sil::ManoeuvreRun right{parameters, manoeuvre, options};
    while (!left.finished()) {
        left.step();
        right.step();
        expect_equal(left.truth(), sil::mirrored(right.truth()), 1e-7);
        if (testing::Test::HasFatalFailure()) {
            FAIL() << "at " << left.truth().time_s << " s";
        }
    }
}

TEST(Symmetry, AMirroredJTurnIsTheMirrorImageThroughRollover) {
    expect_mirror_image(sil::find_manoeuvre("j-turn-110"), 3.0);
}

TEST(Symmetry, AMirroredTurnOnAMirroredBankIsTheMirrorImage) {
    sil::Manoeuvre manoeuvre = sil::find_manoeuvre("j-turn-45");
    manoeuvre.make_road = [](std::uint64_t) { return std::make_unique<sil::BankedCircleRoad>(152.4, 0.08); };
    expect_mirror_image(manoeuvre, 4.0);
}

TEST(Symmetry, TheMirrorImageOfTheMirrorImageIsTheOriginal) {
    sil::ManoeuvreRun run{scenario::large_suv(), sil::find_manoeuvre("j-turn-110")};
    while (run.truth().time_s < 1.5) {
        run.step();
    }
    expect_equal(run.truth(), sil::mirrored(sil::mirrored(run.truth())), 0.0);
}

TEST(Symmetry, ThePanhardRodMovesTwoWheelLiftOffByLessThanTenMilliseconds) {
    const sil::Manoeuvre manoeuvre = sil::find_manoeuvre("j-turn-110");
    sil::RunOptions options;
    const scenario::Outcome left = scenario::drive(scenario::large_suv(), manoeuvre, options);
    options.mirrored = true;
    const scenario::Outcome right = scenario::drive(scenario::large_suv(), manoeuvre, options);
    ASSERT_NE(left.two_wheel_lift_s, scenario::not_yet);
    EXPECT_NEAR(left.two_wheel_lift_s, right.two_wheel_lift_s, 0.010);
    EXPECT_NEAR(left.rsi_crossing_s, right.rsi_crossing_s, 0.010);
    EXPECT_NEAR(left.ssf_crossing_s, right.ssf_crossing_s, 0.010);
}

}  // namespace
