// The effect of a load on m_s H, learnt from ordinary driving.
#include "rsi/adaptation/load_regression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/rsi/support/loaded_drive.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/stages.hpp"

namespace load_regression_test {
namespace {

using rsi_test::LoadedDrive;
using rsi_test::LoadedVehicle;

constexpr int samples_in_two_minutes = 12000;

rsi_test::LoadRegression fresh() {
    return rsi_test::LoadRegression{rsi_test::large_suv()};
}

void drive(rsi_test::LoadRegression& regression, LoadedDrive& course, int samples) {
    for (int k = 0; k < samples; ++k) {
        course.advance();
        const rsi::RollMotion motion = course.motion();
        regression.update(motion, course.load(motion));
    }
}

rsi_test::LoadRegression after_two_minutes(const LoadedVehicle& vehicle, std::uint64_t seed = 1U) {
    rsi_test::LoadRegression regression = fresh();
    LoadedDrive course(rsi_test::large_suv(), vehicle, seed);
    drive(regression, course, samples_in_two_minutes);
    return regression;
}

double excess_after_two_minutes(const LoadedVehicle& vehicle, std::uint64_t seed = 1U) {
    return static_cast<double>(after_two_minutes(vehicle, seed).excess());
}

TEST(LoadRegression, KnowsNothingAtFirst) {
    const rsi_test::LoadRegression regression = fresh();
    EXPECT_EQ(regression.excess(), 0.0F);
    EXPECT_EQ(regression.excess_deviation(), 0.25F);
}

TEST(LoadRegression, FindsALoadWithinTwoMinutes) {
    for (const double excess : {-0.2, 0.0, 0.3, 0.6}) {
        LoadedVehicle vehicle;
        vehicle.excess = excess;
        const rsi_test::LoadRegression regression = after_two_minutes(vehicle);
        EXPECT_NEAR(static_cast<double>(regression.excess()), excess, 0.04);
        EXPECT_LT(regression.excess_deviation(), 0.05F);
    }
}

TEST(LoadRegression, IsSlow) {
    LoadedVehicle vehicle;
    vehicle.excess = 0.4;
    rsi_test::LoadRegression regression = fresh();
    LoadedDrive course(rsi_test::large_suv(), vehicle);
    drive(regression, course, 300);
    EXPECT_LT(regression.excess(), 0.3F);
}

TEST(LoadRegression, OffsetsOfTheSensorsAreNoLoad) {
    for (const double force_offset : {-0.3, 0.3}) {
        for (const double angle_offset : {-0.005, 0.005}) {
            LoadedVehicle vehicle;
            vehicle.excess = 0.3;
            vehicle.force_offset_mps2 = force_offset;
            vehicle.angle_offset_rad = angle_offset;
            EXPECT_NEAR(excess_after_two_minutes(vehicle), 0.3, 0.06) << force_offset << ' ' << angle_offset;
        }
    }
}

// A constant and a slope of forces of one sign look alike, so it takes longer, and says so.
TEST(LoadRegression, TurnsOfOneDirectionShowLessAndTheDeviationSaysSo) {
    for (const int direction : {-1, 1}) {
        LoadedVehicle vehicle;
        vehicle.excess = 0.3;
        vehicle.direction = direction;
        const rsi_test::LoadRegression regression = after_two_minutes(vehicle);
        EXPECT_NEAR(static_cast<double>(regression.excess()), 0.3, 0.1);
        EXPECT_GT(regression.excess_deviation(), after_two_minutes(LoadedVehicle{}).excess_deviation());
        // With an offset it errs by no more than it says.
        vehicle.force_offset_mps2 = 0.2;
        const rsi_test::LoadRegression with_offset = after_two_minutes(vehicle);
        EXPECT_NEAR(with_offset.excess(), 0.3F, 3.0F * with_offset.excess_deviation());
    }
}

TEST(LoadRegression, LightDrivingShowsLittleAndKeepsTheDeviation) {
    LoadedVehicle vehicle;
    vehicle.excess = 0.3;
    vehicle.strength = 0.25;  // up to 0.1 g
    const rsi_test::LoadRegression regression = after_two_minutes(vehicle);
    EXPECT_GT(regression.excess_deviation(), 0.05F);
    EXPECT_NEAR(regression.excess(), 0.3F, 3.0F * regression.excess_deviation());
}

// 10 % too little of K looks like a load of 10 % and gravity's share: it is corrected as one, and no further.
TEST(LoadRegression, AnErrorOfTheStiffnessIsALoadOfAboutItsSize) {
    for (const double share : {0.9, 1.1}) {
        LoadedVehicle vehicle;
        vehicle.stiffness_share = share;
        EXPECT_NEAR(excess_after_two_minutes(vehicle), 1.0 / share - 1.0, 0.04);
    }
}

TEST(LoadRegression, AMirroredDriveTeachesTheSame) {
    LoadedVehicle vehicle;
    vehicle.excess = 0.35;
    vehicle.noise_share = 0.0;
    const rsi::LearntLoad there = after_two_minutes(vehicle).learnt();
    vehicle.side = -1.0;
    const rsi::LearntLoad mirrored = after_two_minutes(vehicle).learnt();
    EXPECT_EQ(mirrored.excess, there.excess);
    EXPECT_EQ(mirrored.excess_deviation, there.excess_deviation);
    EXPECT_EQ(mirrored.offset_mps2, -there.offset_mps2);
}

// One sample of a turn, as a motion that the calibrated vehicle would not show.
struct Turn {
    rsi::RollMotion motion{};
    rsi::TransferredLoad load{};
};

Turn turn_with(float force_mps2, float load_transfer_ratio) {
    Turn turn;
    turn.motion.road_parallel_force_mps2 = force_mps2;
    turn.motion.road_normal_force_mps2 = 9.8F;
    turn.motion.roll_angle_rad = 0.02F * force_mps2;
    turn.load.suspension_moment_nm = 1920.0F * force_mps2;
    turn.load.ratio = load_transfer_ratio;
    return turn;
}

bool learns_from(const Turn& turn) {
    rsi_test::LoadRegression regression = fresh();
    regression.update(turn.motion, turn.load);
    return regression.excess() != 0.0F;
}

TEST(LoadRegression, LearnsInOrdinaryTurnsOnly) {
    for (const float side : {-1.0F, 1.0F}) {
        EXPECT_FALSE(learns_from(turn_with(side * 0.79F, 0.1F)));
        EXPECT_TRUE(learns_from(turn_with(side * 0.81F, 0.1F)));
        EXPECT_TRUE(learns_from(turn_with(side * 3.99F, 0.5F)));
        EXPECT_FALSE(learns_from(turn_with(side * 4.01F, 0.5F)));
        EXPECT_TRUE(learns_from(turn_with(side * 3.0F, side * 0.69F)));
        EXPECT_FALSE(learns_from(turn_with(side * 3.0F, side * 0.71F)));
    }
}

TEST(LoadRegression, EndsAtItsBounds) {
    for (const double excess : {-0.75, 1.6}) {
        LoadedVehicle vehicle;
        vehicle.excess = excess;
        vehicle.strength = (excess > 0.0) ? 0.6 : 1.0;
        const float bound = (excess > 0.0) ? 1.0F : -0.6F;
        EXPECT_NEAR(after_two_minutes(vehicle).excess(), bound, 0.1F) << excess;
    }
}

TEST(LoadRegression, AKerbTeachesLittle) {
    LoadedVehicle vehicle;
    rsi_test::LoadRegression regression = fresh();
    LoadedDrive course(rsi_test::large_suv(), vehicle);
    drive(regression, course, samples_in_two_minutes);
    const float before = regression.excess();
    Turn struck = turn_with(3.0F, 0.3F);
    struck.motion.roll_acceleration_radps2 = 30.0F;
    for (int k = 0; k < 10; ++k) {
        regression.update(struck.motion, struck.load);
    }
    EXPECT_NEAR(regression.excess(), before, 0.005F);
}

// A sample of an upright body whose springs hold `beyond_mps2` more than the calibrated body needs.
Turn upright_turn(float force_mps2, float beyond_mps2) {
    const rsi_parameters p = rsi_test::large_suv();
    Turn turn = turn_with(force_mps2, 0.5F);
    turn.motion.roll_angle_rad = 0.0F;
    turn.load.suspension_moment_nm =
        p.sprung_mass_kg * (p.sprung_cg_height_m - p.fixed_roll_centre_height_m) * (force_mps2 + beyond_mps2);
    return turn;
}

// At first, by hand: P = diag(0.0625, 0.25) and psi = [3; 1] spread the equation by 0.8125, its own noise is
// (0.03 g)^2 = 0.08655 m^2/s^4 and as large for 200 samples, so that three standard deviations are 2.84
// m/s^2.
TEST(LoadRegression, BeyondThreeStandardDeviationsASampleLosesWeightWithItsSize) {
    const auto learnt_from = [](float beyond_mps2) {
        rsi_test::LoadRegression regression = fresh();
        const Turn turn = upright_turn(3.0F, beyond_mps2);
        regression.update(turn.motion, turn.load);
        return regression.excess();
    };
    constexpr float for_one_mps2 = 0.0103455F;  // 0.1875 / (0.8125 + 200 * 0.08655)
    EXPECT_NEAR(learnt_from(2.8F), 2.8F * for_one_mps2, 1.0e-5F);
    EXPECT_NEAR(learnt_from(10.0F), 8.0916F / 10.0F * for_one_mps2, 1.0e-5F);
    EXPECT_NEAR(learnt_from(-10.0F), -8.0916F / 10.0F * for_one_mps2, 1.0e-5F);
}

// Sensors that are off by more are not excused by the offset.
TEST(LoadRegression, TheOffsetEndsAtItsBound) {
    for (const float offset_mps2 : {-4.0F, 4.0F}) {
        rsi_test::LoadRegression regression = fresh();
        for (int k = 0; k < 20000; ++k) {
            const Turn turn = upright_turn((k % 2 == 0) ? 3.0F : -3.0F, offset_mps2);
            regression.update(turn.motion, turn.load);
        }
        EXPECT_EQ(regression.learnt().offset_mps2, std::copysign(2.0F, offset_mps2));
    }
}

TEST(LoadRegression, ForgetsWithTimeHowWellItKnew) {
    rsi_test::LoadRegression regression = after_two_minutes(LoadedVehicle{});
    const float known = regression.excess_deviation();
    const float excess = regression.excess();
    for (int k = 0; k < 360000; ++k) {
        regression.pass_time();
    }
    EXPECT_EQ(regression.excess(), excess);
    EXPECT_GT(regression.excess_deviation(), 2.0F * known);
    EXPECT_LE(regression.excess_deviation(), 0.25F);
}

TEST(LoadRegression, ADoubtHalvesWhatIsLearntAndWidensTheDeviation) {
    LoadedVehicle vehicle;
    vehicle.excess = 0.4;
    rsi_test::LoadRegression regression = after_two_minutes(vehicle);
    const float learnt = regression.excess();
    regression.doubt(0.0F);
    EXPECT_NEAR(regression.excess(), 0.5F * learnt, 1.0e-6F);
    EXPECT_GT(regression.excess_deviation(), 0.15F);
    regression.doubt(0.0F);
    regression.doubt(0.0F);
    EXPECT_EQ(regression.excess_deviation(), 0.25F);  // not less than nothing is known
    LoadedDrive course(rsi_test::large_suv(), vehicle, 2U);
    drive(regression, course, samples_in_two_minutes);
    EXPECT_NEAR(regression.excess(), 0.4F, 0.05F);
}

rsi_test::LoadRegression knowing(const rsi::LearntLoad& learnt) {
    rsi_test::LoadRegression regression = fresh();
    EXPECT_TRUE(regression.restore(learnt));
    return regression;
}

TEST(LoadRegression, ADoubtAddsADeviationOf15Percent) {
    rsi_test::LoadRegression regression = knowing({0.4F, 0.08F, 0.1F});
    regression.doubt(0.0F);
    EXPECT_NEAR(regression.excess_deviation(), 0.17F, 1.0e-6F);  // 0.08^2 + 0.15^2
}

TEST(LoadRegression, ADoubtGoesHalfTheWayToWhatIsExpected) {
    rsi_test::LoadRegression regression = fresh();
    regression.doubt(0.4F);
    EXPECT_NEAR(regression.excess(), 0.2F, 1.0e-6F);
    for (int k = 0; k < 10; ++k) {
        regression.doubt(3.0F);
    }
    EXPECT_EQ(regression.excess(), 1.0F);
    for (int k = 0; k < 10; ++k) {
        regression.doubt(-3.0F);
    }
    EXPECT_EQ(regression.excess(), -0.6F);
}

TEST(LoadRegression, AnExpectationMovesWhatIsNotKnown) {
    rsi_test::LoadRegression regression = fresh();
    regression.expect_change(0.4F);
    EXPECT_NEAR(regression.excess(), 0.4F, 1.0e-6F);
    regression.expect_change(5.0F);
    EXPECT_EQ(regression.excess(), 1.0F);
    regression.expect_change(-5.0F);
    EXPECT_EQ(regression.excess(), -0.6F);
    rsi_test::LoadRegression driven = after_two_minutes(LoadedVehicle{});
    const float known = driven.excess();
    driven.expect_change(0.4F);
    EXPECT_NEAR(driven.excess(), known, 0.02F);
}

TEST(LoadRegression, ALoadThatIsPutOnIsKnownToHalfOfIt) {
    rsi_test::LoadRegression regression = knowing({0.1F, 0.03F, 0.1F});
    regression.add_load(0.08F);
    EXPECT_NEAR(regression.excess(), 0.18F, 1.0e-6F);
    EXPECT_NEAR(regression.excess_deviation(), 0.05F, 1.0e-6F);  // 0.03^2 + 0.04^2
    regression.add_load(5.0F);
    EXPECT_EQ(regression.excess(), 1.0F);
    EXPECT_EQ(regression.excess_deviation(), 0.25F);  // not less than nothing is known
    regression.add_load(-5.0F);
    EXPECT_EQ(regression.excess(), -0.6F);
}

TEST(LoadRegression, ALearntLoadComesBack) {
    LoadedVehicle vehicle;
    vehicle.excess = 0.4;
    const rsi::LearntLoad learnt = after_two_minutes(vehicle).learnt();
    rsi_test::LoadRegression regression = fresh();
    ASSERT_TRUE(regression.restore(learnt));
    EXPECT_EQ(regression.excess(), learnt.excess);
    EXPECT_EQ(regression.excess_deviation(), learnt.excess_deviation);
    EXPECT_EQ(regression.learnt().offset_mps2, learnt.offset_mps2);
}

// The load and the offset are as independent then as at first: what a turn shows beyond them moves both the
// same way.
TEST(LoadRegression, ARestoredOrAddedLoadSharesOutLaterChangesBetweenLoadAndOffset) {
    const rsi::LearntLoad learnt{0.4F, 0.02F, 0.1F};
    for (const bool puts_on : {false, true}) {
        for (const float force_mps2 : {-3.0F, 3.0F}) {
            rsi_test::LoadRegression regression = knowing(learnt);
            if (puts_on) {
                regression.add_load(0.0F);
            }
            const Turn turn = turn_with(force_mps2, 0.5F);
            regression.update(turn.motion, turn.load);
            const float of_load = force_mps2 * (regression.excess() - learnt.excess);
            const float of_offset = regression.learnt().offset_mps2 - learnt.offset_mps2;
            EXPECT_GT(of_load * of_offset, 0.0F);
            EXPECT_LT(std::abs(of_load), 0.001F);
        }
    }
}

TEST(LoadRegression, RefusesWhatCannotHaveBeenLearnt) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const rsi::LearntLoad good{0.2F, 0.05F, 0.1F};
    ASSERT_TRUE(fresh().restore(good));
    EXPECT_TRUE(fresh().restore({-0.599F, 0.0101F, -1.99F}));
    EXPECT_TRUE(fresh().restore({0.999F, 0.249F, 1.99F}));
    for (const float excess : {nan, -0.61F, 1.01F}) {
        EXPECT_FALSE(fresh().restore({excess, 0.05F, 0.1F}));
    }
    for (const float deviation : {nan, 0.0F, 0.009F, 0.26F, -0.05F}) {
        EXPECT_FALSE(fresh().restore({0.2F, deviation, 0.1F}));
    }
    for (const float offset : {nan, -2.1F, 2.1F}) {
        EXPECT_FALSE(fresh().restore({0.2F, 0.05F, offset}));
    }
    rsi_test::LoadRegression regression = fresh();
    regression.restore({nan, 0.05F, 0.1F});
    EXPECT_EQ(regression.excess(), 0.0F);
}

// Sums that overflow.
Turn impossible_turn() {
    Turn turn = turn_with(3.0F, 0.5F);
    turn.motion.road_normal_force_mps2 = 1.0e38F;
    turn.motion.roll_angle_rad = 0.4F;
    return turn;
}

TEST(LoadRegression, ForgetsAllRatherThanToKeepWhatIsNoNumber) {
    rsi_test::LoadRegression regression = fresh();
    ASSERT_TRUE(regression.restore({0.4F, 0.02F, 0.1F}));
    const Turn good = turn_with(3.0F, 0.5F);
    EXPECT_TRUE(regression.update(good.motion, good.load));
    const Turn bad = impossible_turn();
    EXPECT_FALSE(regression.update(bad.motion, bad.load));
    EXPECT_EQ(regression.excess(), 0.0F);
    EXPECT_EQ(regression.excess_deviation(), 0.25F);
}

TEST(LoadRegression, NoInputBringsItOutOfItsBounds) {
    rsi_test::Noise noise(11U);
    const auto any = [&noise](double limit) {
        return static_cast<float>(limit * (2.0 * noise.unit() - 1.0));
    };
    rsi_test::LoadRegression regression = fresh();
    for (int k = 0; k < 1000000; ++k) {
        const double scale = std::pow(10.0, 8.0 * noise.unit());
        Turn turn = turn_with(any(6.0), any(1.0));
        turn.motion.road_normal_force_mps2 = 1.0F + std::fabs(any(60.0));
        turn.motion.roll_angle_rad = any(0.5);
        turn.motion.roll_rate_radps = any(10.0);
        turn.motion.roll_acceleration_radps2 = any(1.0e3);
        turn.load.suspension_moment_nm = any(scale);
        regression.update(turn.motion, turn.load);
        const rsi::LearntLoad learnt = regression.learnt();
        ASSERT_GE(learnt.excess, -0.6F);
        ASSERT_LE(learnt.excess, 1.0F);
        ASSERT_GE(learnt.excess_deviation, 0.01F);
        ASSERT_LE(learnt.excess_deviation, 0.25F);
        ASSERT_LE(std::fabs(learnt.offset_mps2), 2.0F);
    }
}

}  // namespace
}  // namespace load_regression_test
