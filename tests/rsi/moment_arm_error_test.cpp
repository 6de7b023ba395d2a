// The slow share by which the calibrated roll equation disagrees with the vehicle, and the load transfer that
// is a mean of what the suspension and what the forces say.
#include "rsi/prediction/moment_arm_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rsi/indicator/load_transfer.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/stages.hpp"

namespace moment_arm_error_test {
namespace {

constexpr double g = 9.80665;

// A steady turn of a vehicle whose moment arm is (1 - e) times the calibrated one.
struct SteadyTurn {
    rsi::RollMotion motion{};
    rsi::TransferredLoad load{};
};

SteadyTurn steady_turn(const rsi_parameters& p, double force_mps2, double e) {
    const double arm = static_cast<double>(p.sprung_mass_kg) *
                       static_cast<double>(p.sprung_cg_height_m - p.fixed_roll_centre_height_m);
    const rsi::Vehicle vehicle{p};
    double phi = 0.0;
    for (int step = 0; step < 200; ++step) {
        const double wanted = arm * (1.0 - e) * (force_mps2 + g * phi * (1.0 + phi * phi / 3.0));
        const double held = static_cast<double>(vehicle.suspension_moment_nm(static_cast<float>(phi), 0.0F));
        phi += 0.5 * (wanted - held) / static_cast<double>(p.roll_stiffness_nmprad);
    }
    SteadyTurn turn;
    turn.motion.road_parallel_force_mps2 = static_cast<float>(force_mps2);
    turn.motion.road_normal_force_mps2 = static_cast<float>(g);
    turn.motion.roll_angle_rad = static_cast<float>(phi);
    turn.load.suspension_moment_nm = vehicle.suspension_moment_nm(turn.motion.roll_angle_rad, 0.0F);
    return turn;
}

float after(const rsi_parameters& p, const SteadyTurn& turn, int samples, float load_transfer_ratio = 0.5F,
            bool measured = true) {
    rsi_test::MomentArmError error{p};
    rsi::TransferredLoad load = turn.load;
    load.ratio = load_transfer_ratio;
    float e = 0.0F;
    for (int k = 0; k < samples; ++k) {
        e = error.update(turn.motion, load, measured);
    }
    return e;
}

TEST(MomentArmError, IsZeroForTheCalibratedVehicle) {
    const rsi_parameters p = rsi_test::large_suv();
    EXPECT_NEAR(after(p, steady_turn(p, 4.0, 0.0), 300), 0.0F, 1.0e-4F);
}

// The prior pulls it towards zero, so it stays short of the truth, on either side and in either direction.
TEST(MomentArmError, GoesMostOfTheWayToWhatAnotherVehicleShows) {
    const rsi_parameters p = rsi_test::large_suv();
    for (const double force : {-5.0, 5.0}) {
        for (const double e : {-0.1, 0.1}) {
            const float found = after(p, steady_turn(p, force, e), 200);
            EXPECT_GT(found / static_cast<float>(e), 0.5F) << force << " " << e;
            EXPECT_LT(found / static_cast<float>(e), 1.02F) << force << " " << e;
        }
    }
}

TEST(MomentArmError, IsSlowerThanATurn) {
    const rsi_parameters p = rsi_test::large_suv();
    const SteadyTurn turn = steady_turn(p, 5.0, 0.1);
    EXPECT_LT(after(p, turn, 2), 0.7F * after(p, turn, 200));
}

TEST(MomentArmError, LearnsNothingWithTheWheelsUpOrWithoutATurn) {
    const rsi_parameters p = rsi_test::large_suv();
    EXPECT_EQ(after(p, steady_turn(p, 5.0, 0.1), 100, 1.0F), 0.0F);
    EXPECT_EQ(after(p, steady_turn(p, -5.0, 0.1), 100, -1.0F), 0.0F);
    EXPECT_EQ(after(p, steady_turn(p, 0.5, 0.1), 100), 0.0F);
}

TEST(MomentArmError, LearnsNothingFromTheObserversAngle) {
    const rsi_parameters p = rsi_test::large_suv();
    EXPECT_EQ(after(p, steady_turn(p, 5.0, 0.1), 100, 0.5F, false), 0.0F);
}

TEST(MomentArmError, ReturnsToZeroWhereNothingIsLearnt) {
    const rsi_parameters p = rsi_test::large_suv();
    const SteadyTurn turn = steady_turn(p, 5.0, 0.1);
    const SteadyTurn straight = steady_turn(p, 0.0, 0.0);
    rsi_test::MomentArmError error{p};
    float e = 0.0F;
    for (int k = 0; k < 200; ++k) {
        e = error.update(turn.motion, turn.load, true);
    }
    const float learnt = e;
    for (int k = 0; k < 1000; ++k) {
        e = error.update(straight.motion, straight.load, true);
    }
    ASSERT_GT(learnt, 0.05F);
    EXPECT_LT(e, 0.01F * learnt);
}

TEST(LoadTransfer, IsTheMeanThatTheWeightSays) {
    const rsi_parameters p = rsi_test::large_suv();
    rsi::RollMotion motion;
    motion.road_parallel_force_mps2 = 5.0F;
    motion.road_normal_force_mps2 = 9.5F;
    motion.roll_angle_rad = 0.07F;
    motion.roll_acceleration_radps2 = 2.0F;
    const double m_s = static_cast<double>(p.sprung_mass_kg);
    const double h = static_cast<double>(p.sprung_cg_height_m);
    const double h_rc = static_cast<double>(p.fixed_roll_centre_height_m);
    const double unsprung =
        static_cast<double>(p.unsprung_mass_kg) * static_cast<double>(p.unsprung_cg_height_m);
    motion.roll_rate_radps = 0.2F;
    const rsi::Vehicle vehicle{p};
    const auto suspension_nm =
        static_cast<double>(vehicle.suspension_moment_nm(motion.roll_angle_rad, motion.roll_rate_radps));
    const double by_suspension = (m_s * h_rc + unsprung) * 5.0 + suspension_nm;
    const double by_forces = (m_s * h + unsprung) * 5.0 +
                             m_s * (h - h_rc) * 9.5 * (0.07 + 0.07 * 0.07 * 0.07 / 3.0) -
                             static_cast<double>(p.roll_inertia_kgm2) * 2.0;
    for (const double weight : {0.0, 0.3, 1.0}) {
        const rsi::TransferredLoad load = rsi::transferred_load(vehicle, static_cast<float>(weight), motion);
        EXPECT_NEAR(static_cast<double>(load.moment_nm), (1.0 - weight) * by_suspension + weight * by_forces,
                    0.02);
    }
}

// The vehicle has fallen to a side when its linear springs alone would hold one and a half times the weight:
// then it is theirs, whatever force, damper and bump stops seem to say.
TEST(LoadTransfer, OfABodyThatIsOverIsThatOfItsLinearSprings) {
    rsi_parameters p = rsi_test::large_suv();
    p.roll_stiffness_cubic_nmprad3 = 0.0F;
    p.roll_stiffness_quintic_nmprad5 = -2.0e7F;  // fitted to small angles only
    const rsi::Vehicle vehicle{p};
    const auto load_of = [&](const rsi::RollMotion& motion) {
        return rsi::transferred_load(vehicle, p.load_transfer_inertial_weight, motion);
    };
    const float lifts_rad =
        0.5F * (p.sprung_mass_kg + p.unsprung_mass_kg) * 9.8F * p.track_width_m / p.roll_stiffness_nmprad;
    ASSERT_LT(1.51F * lifts_rad, 0.5F);
    for (const float side : {1.0F, -1.0F}) {
        rsi::RollMotion motion;
        motion.road_normal_force_mps2 = 9.8F;
        motion.road_parallel_force_mps2 = side * -8.0F;
        motion.roll_rate_radps = side * -3.0F;
        motion.roll_angle_rad = side * 1.51F * lifts_rad;
        EXPECT_NEAR(load_of(motion).ratio, side * 1.51F, 1.0e-4F);
        motion.roll_angle_rad = side * 1.49F * lifts_rad;
        EXPECT_LT(side * load_of(motion).ratio, 0.0F);
        const rsi::TransferredLoad load = load_of(motion);
        EXPECT_EQ(load.ratio, rsi::load_transfer_ratio(vehicle.loaded, load.moment_nm, 9.8F));
    }
}

TEST(MomentArmError, EndsAtItsLimitOnEitherSide) {
    const rsi_parameters p = rsi_test::large_suv();
    EXPECT_EQ(after(p, steady_turn(p, 8.0, 0.7), 400), 0.35F);
    EXPECT_EQ(after(p, steady_turn(p, 4.0, -0.7), 400), -0.35F);
}

TEST(MomentArmError, KnowsNothingAtTheStartSoItsFirstStepsAreLarge) {
    const rsi_parameters p = rsi_test::large_suv();
    const SteadyTurn turn = steady_turn(p, 5.0, 0.1);
    EXPECT_GT(after(p, turn, 2), 0.1F * after(p, turn, 200));
}

}  // namespace
}  // namespace moment_arm_error_test
