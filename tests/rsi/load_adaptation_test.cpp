// The load that is learnt and what the component makes of it: the long stop, the split into mass and height,
// the margin, what lasts and what is doubted.
#include "rsi/adaptation/load_adaptation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rsi/adaptation/load_split.hpp"
#include "rsi/component.hpp"
#include "tests/rsi/support/loaded_drive.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/stages.hpp"

namespace load_adaptation_test {
namespace {

using rsi_test::LoadedDrive;
using rsi_test::LoadedVehicle;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr double speed_mps = 20.0;
constexpr int samples_in_two_minutes = 12000;
constexpr int samples_in_a_minute = 6000;

rsi_parameters adapting(float share = 1.0F, float margin = 0.0F) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.load_adaptation = share;
    parameters.load_margin = margin;
    return parameters;
}

LoadedVehicle loaded_by(double excess) {
    LoadedVehicle vehicle;
    vehicle.excess = excess;
    return vehicle;
}

// The vehicle's mass as other control units send it, when m_s is so much larger than calibrated.
float mass_with(float mass_factor) {
    const rsi_parameters p = rsi_test::large_suv();
    return mass_factor * p.sprung_mass_kg + p.unsprung_mass_kg;
}

TEST(LongStop, BeginsOnceAfterSixtySeconds) {
    rsi::LongStop stop;
    for (int k = 0; k < samples_in_a_minute; ++k) {
        ASSERT_FALSE(stop.begins((k % 2 == 0) ? 0.49F : -0.49F));
    }
    EXPECT_TRUE(stop.begins(0.0F));
    for (int k = 0; k < 2 * samples_in_a_minute; ++k) {
        ASSERT_FALSE(stop.begins(0.0F));
    }
}

TEST(LongStop, EndsAtHalfAMetrePerSecond) {
    rsi::LongStop stop;
    for (int k = 0; k < samples_in_a_minute; ++k) {
        stop.begins(0.0F);
    }
    EXPECT_TRUE(stop.is_standing());
    EXPECT_FALSE(stop.begins(0.5F));
    EXPECT_FALSE(stop.is_standing());
    EXPECT_FALSE(stop.begins(0.0F));
    EXPECT_TRUE(stop.is_standing());
    stop.begins(-0.5F);  // in reverse
    EXPECT_FALSE(stop.is_standing());
}

TEST(LongStop, WithoutASpeedItNeitherBeginsNorEnds) {
    rsi::LongStop stop;
    for (int k = 0; k < 2 * samples_in_a_minute; ++k) {
        ASSERT_FALSE(stop.begins(nan));
    }
    EXPECT_FALSE(stop.is_standing());
    for (int k = 0; k < samples_in_a_minute; ++k) {
        stop.begins(0.0F);
        stop.begins(nan);
        stop.begins(151.0F);
    }
    EXPECT_TRUE(stop.is_standing());
    EXPECT_TRUE(stop.begins(0.0F));
    stop.begins(149.0F);
    EXPECT_FALSE(stop.is_standing());
}

TEST(LoadSplit, SharesOutBetweenMassAndHeight) {
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    for (const float moment : {0.8F, 1.0F, 1.44F, 2.0F}) {
        for (const float mass : {rsi::assumed_mass_factor(moment), 1.0F, (moment < 1.0F) ? 0.9F : 1.1F}) {
            const rsi::SprungBody loaded = rsi::with_load(empty, moment, mass);
            EXPECT_FLOAT_EQ(loaded.mass_kg, std::fmax(mass, moment / 1.7F) * empty.mass_kg);
            EXPECT_FLOAT_EQ(loaded.roll_inertia_kgm2, moment * empty.roll_inertia_kgm2);
            EXPECT_FLOAT_EQ(loaded.cg_height_m - loaded.roll_arm_m, empty.cg_height_m - empty.roll_arm_m);
            EXPECT_FLOAT_EQ(loaded.moment_arm_kgm(), moment * empty.moment_arm_kgm());
        }
    }
    EXPECT_FLOAT_EQ(rsi::assumed_mass_factor(1.44F), 1.2F);
}

TEST(LoadSplit, TakesWhatIsMissingForMassRatherThanForAMuchLowerBody) {
    EXPECT_FLOAT_EQ(rsi::assumed_mass_factor(0.9F), std::sqrt(0.9F));
    EXPECT_FLOAT_EQ(rsi::assumed_mass_factor(0.7F), 0.7F / 0.93F);
    const rsi::SprungBody full = rsi::calibrated_body(rsi_test::large_suv());
    EXPECT_FLOAT_EQ(rsi::with_load(full, 0.7F, rsi::assumed_mass_factor(0.7F)).roll_arm_m,
                    0.93F * full.roll_arm_m);
}

TEST(LoadSplit, WithoutALoadItIsTheCalibratedBodyToTheLastBit) {
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    const rsi::SprungBody same = rsi::with_load(empty, 1.0F, rsi::assumed_mass_factor(1.0F));
    EXPECT_EQ(same.mass_kg, empty.mass_kg);
    EXPECT_EQ(same.cg_height_m, empty.cg_height_m);
    EXPECT_EQ(same.roll_arm_m, empty.roll_arm_m);
    EXPECT_EQ(same.roll_inertia_kgm2, empty.roll_inertia_kgm2);
}

TEST(LoadSplit, NoLoadBringsTheHeightFurtherThanALoadCan) {
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    EXPECT_FLOAT_EQ(rsi::with_load(empty, 2.0F, 0.6F).roll_arm_m, 1.7F * empty.roll_arm_m);
    EXPECT_FLOAT_EQ(rsi::with_load(empty, 0.5F, 0.9F).roll_arm_m, 0.6F * empty.roll_arm_m);
    const rsi::SprungBody flat{1000.0F, 0.2F, 0.7F, 300.0F};  // about a roll centre above it
    EXPECT_EQ(rsi::with_load(flat, 0.7F, 1.0F).cg_height_m, 0.2F);
}

// A trailer in the received mass, or a wrong one.
TEST(LoadSplit, AHeavierBodyIsHardlyLower) {
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    EXPECT_FLOAT_EQ(rsi::with_load(empty, 1.0F, 1.5F).roll_arm_m, 0.9F * empty.roll_arm_m);
    EXPECT_FLOAT_EQ(rsi::with_load(empty, 1.3F, 1.4F).mass_kg, 1.4F * empty.mass_kg);
    EXPECT_FLOAT_EQ(rsi::with_load(empty, 0.7F, 3.0F).mass_kg, empty.mass_kg);
}

TEST(LoadSplit, TakesForNoLoadThatWhichAWrongCalibrationMakes) {
    for (const float sign : {1.0F, -1.0F}) {
        for (const float excess : {0.0F, 0.05F, 0.1F}) {
            EXPECT_EQ(rsi::excess_beyond_errors(sign * excess), 0.0F);
        }
        EXPECT_FLOAT_EQ(rsi::excess_beyond_errors(sign * 0.15F), sign * 0.1F);
        EXPECT_FLOAT_EQ(rsi::excess_beyond_errors(sign * 0.2F), sign * 0.2F);
        EXPECT_FLOAT_EQ(rsi::excess_beyond_errors(sign * 0.5F), sign * 0.5F);
    }
}

TEST(LoadSplit, CountsTheErrorsFromWhatTheMassSays) {
    EXPECT_FLOAT_EQ(rsi::excess_beside_mass(0.35F, 0.4F), 0.4F);
    EXPECT_FLOAT_EQ(rsi::excess_beside_mass(0.7F, 0.4F), 0.7F);
    EXPECT_FLOAT_EQ(rsi::excess_beside_mass(-0.5F, -0.35F), -0.45F);
}

// Leaf springs that stick look so in small turns.
TEST(LoadSplit, WithItsMassABodyIsNotTakenForALightOne) {
    EXPECT_EQ(rsi::excess_beside_mass(-0.4F, 0.0F), 0.0F);
    EXPECT_FLOAT_EQ(rsi::excess_beside_mass(-0.4F, 0.1F), 0.0F);
    EXPECT_FLOAT_EQ(rsi::excess_beside_mass(-0.6F, -0.2F), -0.4F);
}

// A load that driving has shown: as low as a load may lie, and what errors of axle loads and
// calibration make.
TEST(LoadSplit, AdmitsAMassThatTheShownLoadCanHave) {
    EXPECT_EQ(rsi::admitted_mass_change(0.039F, 0.0F), 0.039F);
    EXPECT_EQ(rsi::admitted_mass_change(-0.039F, 0.0F), -0.039F);
    EXPECT_FLOAT_EQ(rsi::admitted_mass_change(0.3F, 0.09F), 0.04F);
    EXPECT_FLOAT_EQ(rsi::admitted_mass_change(-0.3F, 0.0F), -0.04F);
    EXPECT_EQ(rsi::admitted_mass_change(0.43F, 0.2F), 0.43F);
    EXPECT_FLOAT_EQ(rsi::admitted_mass_change(1.0F, 0.2F), 0.44F);
    EXPECT_FLOAT_EQ(rsi::admitted_mass_change(-0.2F, 0.2F), -0.04F);
    EXPECT_FLOAT_EQ(rsi::admitted_mass_change(-1.0F, -0.2F), -0.44F);
    EXPECT_FLOAT_EQ(rsi::admitted_mass_change(0.2F, -0.2F), 0.04F);
}

TEST(LoadSplit, AMassFarBeyondTheShownLoadContradictsItOnceThatIsSure) {
    EXPECT_FALSE(rsi::contradicts_load(0.28F, 0.0F, 0.05F));
    EXPECT_TRUE(rsi::contradicts_load(0.30F, 0.0F, 0.05F));
    EXPECT_FALSE(rsi::contradicts_load(0.30F, 0.0F, 0.06F));
    EXPECT_FALSE(rsi::contradicts_load(-0.28F, 0.0F, 0.05F));
    EXPECT_TRUE(rsi::contradicts_load(-0.30F, 0.0F, 0.05F));
    EXPECT_FALSE(rsi::contradicts_load(0.55F, 0.4F, 0.05F));
}

rsi_test::LoadAdaptation started(const rsi_parameters& parameters = adapting()) {
    return rsi_test::LoadAdaptation{parameters};
}

struct Circumstances {
    bool measured_angle{true};
    float speed{static_cast<float>(speed_mps)};
    float mass_kg{nan};
};

void drive(rsi_test::LoadAdaptation& adaptation, const LoadedVehicle& vehicle, int samples,
           const Circumstances& circumstances = {}) {
    LoadedDrive course(rsi_test::large_suv(), vehicle);
    rsi_inputs inputs{};
    inputs.speed_mps = circumstances.speed;
    inputs.vehicle_mass_kg = circumstances.mass_kg;
    for (int k = 0; k < samples; ++k) {
        course.advance();
        const rsi::RollMotion motion = course.motion();
        adaptation.update(inputs, motion, course.load(motion), circumstances.measured_angle);
    }
}

void stand(rsi_test::LoadAdaptation& adaptation, int samples, float mass_kg = nan) {
    rsi_inputs inputs{};
    inputs.vehicle_mass_kg = mass_kg;
    for (int k = 0; k < samples; ++k) {
        adaptation.update(inputs, rsi::RollMotion{}, rsi::TransferredLoad{}, true);
    }
}

TEST(LoadAdaptation, GivesTheBodyThatTheVehicleHas) {
    rsi_test::LoadAdaptation adaptation = started();
    drive(adaptation, loaded_by(0.44), samples_in_two_minutes);
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    const rsi::SprungBody body = adaptation.body();
    EXPECT_NEAR(body.moment_arm_kgm() / empty.moment_arm_kgm(), 1.44F, 0.05F);
    EXPECT_NEAR(body.mass_kg / empty.mass_kg, 1.2F, 0.03F);
}

TEST(LoadAdaptation, UsesAsMuchAsTheCalibrationWants) {
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    const auto moment_factor = [&empty](float share) {
        rsi_test::LoadAdaptation adaptation = started(adapting(share, 1.0F));
        drive(adaptation, loaded_by(0.4), samples_in_two_minutes);
        return adaptation.body().moment_arm_kgm() / empty.moment_arm_kgm();
    };
    EXPECT_NEAR(moment_factor(0.5F) - 1.0F, 0.5F * (moment_factor(1.0F) - 1.0F), 1.0e-5F);
}

TEST(LoadAdaptation, SwitchedOffItLearnsButLeavesTheCalibratedBodyAndLevel) {
    rsi_test::LoadAdaptation adaptation = started(adapting(0.0F, 1.0F));
    drive(adaptation, loaded_by(0.4), samples_in_two_minutes, {true, 20.0F, mass_with(1.3F)});
    EXPECT_GT(adaptation.learnt().excess, 0.3F);
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    const rsi::SprungBody body = adaptation.body();
    EXPECT_EQ(body.mass_kg, empty.mass_kg);
    EXPECT_EQ(body.cg_height_m, empty.cg_height_m);
    EXPECT_EQ(body.roll_arm_m, empty.roll_arm_m);
    EXPECT_EQ(body.roll_inertia_kgm2, empty.roll_inertia_kgm2);
    EXPECT_EQ(adaptation.level_weight(), 1.0F);
}

TEST(LoadAdaptation, LearnsNothingFromTheObserversAngleNorWhileStanding) {
    for (const Circumstances& circumstances : {Circumstances{false}, Circumstances{true, 0.4F}}) {
        rsi_test::LoadAdaptation adaptation = started();
        drive(adaptation, loaded_by(0.4), 3000, circumstances);
        EXPECT_EQ(adaptation.learnt().excess, 0.0F);
    }
    rsi_test::LoadAdaptation without_speed = started();
    drive(without_speed, loaded_by(0.4), samples_in_two_minutes, {true, nan});
    EXPECT_NEAR(without_speed.learnt().excess, 0.4F, 0.05F);
}

TEST(LoadAdaptation, DoubtsAfterALongStopAndNotAfterAShortOne) {
    rsi_test::LoadAdaptation adaptation = started();
    drive(adaptation, loaded_by(0.4), samples_in_two_minutes);
    const rsi::LearntLoad before = adaptation.learnt();
    stand(adaptation, samples_in_a_minute);
    EXPECT_EQ(adaptation.learnt().excess, before.excess);
    stand(adaptation, 1);
    EXPECT_FLOAT_EQ(adaptation.learnt().excess, 0.5F * before.excess);
    EXPECT_GT(adaptation.learnt().excess_deviation, 3.0F * before.excess_deviation);
    stand(adaptation, samples_in_a_minute);
    EXPECT_FLOAT_EQ(adaptation.learnt().excess, 0.5F * before.excess);  // once a stop
    drive(adaptation, loaded_by(0.0), samples_in_two_minutes);
    EXPECT_NEAR(adaptation.learnt().excess, 0.0F, 0.05F);
}

TEST(LoadAdaptation, TheMassSaysWhatIsMassAndWhatIsHeight) {
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    rsi_test::LoadAdaptation adaptation = started();
    drive(adaptation, loaded_by(0.4), samples_in_two_minutes, {true, 20.0F, mass_with(1.1F)});
    const rsi::SprungBody body = adaptation.body();
    EXPECT_NEAR(body.mass_kg / empty.mass_kg, 1.1F, 1.0e-5F);
    EXPECT_NEAR(body.roll_arm_m / empty.roll_arm_m, 1.4F / 1.1F, 0.05F);
    EXPECT_NEAR(adaptation.known_mass_factor(), 1.1F, 1.0e-5F);
    stand(adaptation, 10);  // it stays while none comes
    EXPECT_EQ(adaptation.body().mass_kg, body.mass_kg);
    EXPECT_EQ(started().known_mass_factor(), 1.0F);
    rsi_test::LoadAdaptation half = started(adapting(0.5F));
    stand(half, 1, mass_with(1.5F));
    EXPECT_NEAR(half.known_mass_factor(), 1.25F, 1.0e-5F);
}

// A trailer, another vehicle's mass, an axle that is not weighed: without a load that is shown the body is as
// it is without a mass.
TEST(LoadAdaptation, AMassThatDrivingDoesNotShowLeavesTheBodyAsItIs) {
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    for (const float factor : {0.7F, 0.8F, 1.2F, 1.5F, 2.0F}) {
        const float side = (factor < 1.0F) ? -1.0F : 1.0F;
        rsi_test::LoadAdaptation at_start = started();
        stand(at_start, 1, mass_with(factor));
        EXPECT_NEAR(at_start.body().mass_kg / empty.mass_kg, 1.0F + 0.04F * side, 1.0e-5F) << factor;
        EXPECT_NEAR(at_start.body().moment_arm_kgm() / empty.moment_arm_kgm(), 1.0F, 0.0401F) << factor;
        drive(at_start, LoadedVehicle{}, samples_in_two_minutes, {true, 20.0F, mass_with(factor)});
        EXPECT_NEAR(at_start.learnt().excess, 0.0F, 0.03F) << factor;
        EXPECT_NEAR(at_start.body().mass_kg / empty.mass_kg, 1.0F, 0.0401F) << factor;
        EXPECT_NEAR(at_start.body().moment_arm_kgm() / empty.moment_arm_kgm(), 1.0F, 0.0401F) << factor;
    }
}

TEST(LoadAdaptation, AMassThatDrivingRefutesIsNone) {
    rsi_test::LoadAdaptation without = started();
    rsi_test::LoadAdaptation with = started();
    for (rsi_test::LoadAdaptation* each : {&without, &with}) {
        ASSERT_TRUE(each->restore({0.0F, 0.02F, 0.0F}, false));
    }
    stand(with, 1, mass_with(1.5F));
    EXPECT_EQ(with.known_mass_factor(), 1.0F);
    EXPECT_EQ(with.body().mass_kg, without.body().mass_kg);
    EXPECT_EQ(with.body().roll_arm_m, without.body().roll_arm_m);
    // Nor does a long stop make a load of it.
    stand(with, samples_in_a_minute + 1, mass_with(1.5F));
    EXPECT_NEAR(with.learnt().excess, 0.0F, 0.01F);
}

// Neither a stop nor a restart turns a mass that was only assumed into a load that was shown.
TEST(LoadAdaptation, AnAssumedLoadStaysAssumedOverALongStop) {
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    rsi_test::LoadAdaptation adaptation = started();
    stand(adaptation, samples_in_a_minute + 1, mass_with(1.5F));
    EXPECT_NEAR(adaptation.learnt().excess, 0.5F, 1.0e-5F);
    EXPECT_NEAR(adaptation.body().mass_kg / empty.mass_kg, 1.04F, 1.0e-5F);
}

TEST(LoadAdaptation, AMassThatChangesWhileTheVehicleDrivesIsNoLoad) {
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    rsi_test::LoadAdaptation adaptation = started();
    drive(adaptation, LoadedVehicle{}, samples_in_two_minutes, {true, 20.0F, mass_with(1.0F)});
    const rsi::LearntLoad known = adaptation.learnt();
    drive(adaptation, LoadedVehicle{}, 1, {true, 20.0F, mass_with(1.2F)});
    EXPECT_NEAR(adaptation.learnt().excess, known.excess, 0.001F);
    EXPECT_NEAR(adaptation.body().mass_kg / empty.mass_kg, 1.04F, 1.0e-5F);
}

TEST(LoadAdaptation, ExcusesMoreRollByTheUsedLoadUpTo30PercentOrByTheMass) {
    EXPECT_EQ(started().roll_factor(), 1.0F);
    const auto learnt = [](float excess, float used_share) {
        rsi_test::LoadAdaptation adaptation = started(adapting(used_share));
        EXPECT_TRUE(adaptation.restore({excess, 0.03F, 0.0F}, false));
        return adaptation;
    };
    EXPECT_NEAR(learnt(0.25F, 1.0F).roll_factor(), 1.25F, 1.0e-5F);
    EXPECT_EQ(learnt(0.4F, 1.0F).roll_factor(), 1.3F);
    EXPECT_NEAR(learnt(0.25F, 0.4F).roll_factor(), 1.1F, 1.0e-5F);
    EXPECT_EQ(learnt(0.09F, 1.0F).roll_factor(), 1.0F);  // as errors of the calibration make
    EXPECT_EQ(learnt(-0.4F, 1.0F).roll_factor(), 1.0F);
    rsi_test::LoadAdaptation weighed = started();
    stand(weighed, 1, mass_with(1.6F));
    EXPECT_NEAR(weighed.roll_factor(), 1.6F, 1.0e-5F);
}

TEST(LoadAdaptation, BeforeAnyDrivingTheMassAloneIsALoadAtTheHeightOfTheBody) {
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    rsi_test::LoadAdaptation adaptation = started();
    stand(adaptation, 1, mass_with(1.5F));
    EXPECT_NEAR(adaptation.learnt().excess, 0.5F, 1.0e-5F);
    rsi_test::LoadAdaptation small = started();
    stand(small, 1, mass_with(0.97F));
    EXPECT_NEAR(small.body().mass_kg / empty.mass_kg, 0.97F, 1.0e-5F);
    EXPECT_NEAR(small.body().roll_arm_m / empty.roll_arm_m, 1.0F, 1.0e-5F);
    // A load shown by driving is not moved by it, and a long stop goes half the way to it.
    rsi_test::LoadAdaptation driven = started();
    drive(driven, loaded_by(0.2), samples_in_two_minutes);
    const float known = driven.learnt().excess;
    stand(driven, 1, mass_with(1.5F));
    EXPECT_NEAR(driven.learnt().excess, known, 0.02F);
    stand(driven, samples_in_a_minute, mass_with(1.5F));
    EXPECT_NEAR(driven.learnt().excess, 0.5F * (known + 0.5F), 0.02F);
}

// Goods at a dock. Fuel and an axle's noise are none.
TEST(LoadAdaptation, AChangeOfTheMassIsALoadPutOnOrTakenOff) {
    rsi_test::LoadAdaptation adaptation = started();
    stand(adaptation, 1, mass_with(1.0F));
    drive(adaptation, LoadedVehicle{}, samples_in_two_minutes);
    const rsi::LearntLoad known = adaptation.learnt();
    ASSERT_LT(known.excess_deviation, 0.05F);
    stand(adaptation, 1, mass_with(1.049F));
    EXPECT_NEAR(adaptation.learnt().excess, known.excess, 0.001F);
    rsi_test::LoadAdaptation slightly_laden = adaptation;
    stand(slightly_laden, 1, mass_with(1.051F));
    EXPECT_NEAR(slightly_laden.learnt().excess, known.excess + 0.051F, 0.001F);
    stand(adaptation, 1, mass_with(1.4F));
    EXPECT_NEAR(adaptation.learnt().excess, known.excess + 0.4F, 0.001F);
    EXPECT_NEAR(adaptation.learnt().excess_deviation, std::hypot(known.excess_deviation, 0.2F), 0.001F);
    // However little at a time.
    for (int step = 1; step <= 100; ++step) {
        stand(adaptation, 1, mass_with(1.4F - 0.004F * static_cast<float>(step)));
    }
    EXPECT_NEAR(adaptation.learnt().excess, known.excess, 0.051F);
    EXPECT_LE(adaptation.learnt().excess_deviation, 0.25F);
}

TEST(LoadAdaptation, ForgetsAllButTheMass) {
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    rsi_test::LoadAdaptation adaptation = started();
    stand(adaptation, 1, mass_with(1.5F));
    drive(adaptation, loaded_by(0.8), samples_in_two_minutes);
    ASSERT_GT(adaptation.learnt().excess, 0.7F);
    adaptation.reset_learnt();
    EXPECT_NEAR(adaptation.learnt().excess, 0.5F, 1.0e-5F);
    EXPECT_NEAR(adaptation.known_mass_factor(), 1.5F, 1.0e-5F);
    EXPECT_NEAR(adaptation.body().mass_kg / empty.mass_kg, 1.04F, 1.0e-5F);
}

TEST(LoadAdaptation, KeepsTheMassWhereWhatIsLearntIsNoNumber) {
    rsi_test::LoadAdaptation adaptation = started();
    stand(adaptation, 1, mass_with(1.5F));
    ASSERT_TRUE(adaptation.restore({0.9F, 0.02F, 0.1F}, false));
    rsi_inputs inputs{};
    inputs.speed_mps = static_cast<float>(speed_mps);
    inputs.vehicle_mass_kg = nan;
    rsi::RollMotion motion;
    motion.road_parallel_force_mps2 = 3.0F;
    motion.road_normal_force_mps2 = 1.0e38F;  // sums overflow
    motion.roll_angle_rad = 0.4F;
    rsi::TransferredLoad load{};
    adaptation.update(inputs, motion, load, true);
    EXPECT_NEAR(adaptation.learnt().excess, 0.5F, 1.0e-5F);
}

TEST(LoadAdaptation, AMassThatIsNotThisVehiclesIsNone) {
    const rsi::SprungBody empty = rsi::calibrated_body(rsi_test::large_suv());
    for (const float mass_kg : {nan, 0.0F, -2000.0F, mass_with(0.59F), mass_with(3.01F), 1.0e30F}) {
        rsi_test::LoadAdaptation adaptation = started();
        stand(adaptation, 1, mass_kg);
        EXPECT_EQ(adaptation.body().mass_kg, empty.mass_kg) << mass_kg;
        EXPECT_EQ(adaptation.learnt().excess, 0.0F) << mass_kg;
    }
}

TEST(LoadAdaptation, AMassFromAnEmptiedTrucksToThreeTimesTheCalibratedIs) {
    for (const float factor : {0.61F, 2.99F}) {
        rsi_test::LoadAdaptation adaptation = started();
        stand(adaptation, 1, mass_with(factor));
        EXPECT_NEAR(adaptation.known_mass_factor(), factor, 1.0e-5F);
    }
}

// However little the first mass differs, it says what the calibration did not know.
TEST(LoadAdaptation, StartsWithoutMassStopAndLoad) {
    rsi_test::LoadAdaptation adaptation = started();
    EXPECT_EQ(adaptation.known_mass_factor(), 1.0F);
    EXPECT_EQ(adaptation.learnt().excess, 0.0F);
    rsi_test::LoadAdaptation with_slightly_more = adaptation;
    stand(with_slightly_more, 1, mass_with(1.03F));
    EXPECT_NEAR(with_slightly_more.learnt().excess, 0.03F, 1.0e-5F);
    rsi_test::LoadAdaptation with_the_same = adaptation;
    stand(with_the_same, 1, mass_with(1.5F));
    EXPECT_NEAR(with_the_same.learnt().excess, 0.5F, 1.0e-5F);
    drive(adaptation, loaded_by(0.4), 1000, {true, nan});  // which would not end a stop
    EXPECT_GT(adaptation.learnt().excess, 0.0F);
}

TEST(LoadAdaptation, AssumesNoLoadThatTheSpringsDoNotHold) {
    rsi_parameters soft = adapting();
    const rsi::SprungBody empty = rsi::calibrated_body(soft);
    soft.roll_stiffness_nmprad = 1.3F * rsi::gravity_mps2 * empty.moment_arm_kgm();
    rsi_test::LoadAdaptation adaptation = started(soft);
    ASSERT_TRUE(adaptation.restore({1.0F, 0.05F, 0.0F}, true));  // halved
    EXPECT_GT(adaptation.learnt().excess, 0.4F);
    EXPECT_NEAR(adaptation.body().moment_arm_kgm() / empty.moment_arm_kgm(), 1.3F / 1.1F, 1.0e-5F);
    // Nor one whose mass would ask for more: then the mass is not used.
    stand(adaptation, 1, mass_with(3.0F));
    EXPECT_NEAR(adaptation.body().moment_arm_kgm() / empty.moment_arm_kgm(), 1.3F / 1.1F, 1.0e-5F);
    EXPECT_NEAR(adaptation.body().roll_arm_m / empty.roll_arm_m, 0.9F, 1.0e-5F);
}

TEST(LoadAdaptation, TheMarginGrowsWithWhatIsNotKnownAndEnds) {
    rsi_test::LoadAdaptation adaptation = started(adapting(1.0F, 0.2F));
    EXPECT_FLOAT_EQ(adaptation.level_weight(), 1.0F + 0.2F * 0.25F);
    drive(adaptation, LoadedVehicle{}, samples_in_two_minutes);
    EXPECT_FLOAT_EQ(adaptation.level_weight(), 1.0F + 0.2F * adaptation.learnt().excess_deviation);
    EXPECT_LT(adaptation.level_weight(), 1.01F);
    EXPECT_FLOAT_EQ(started(adapting(1.0F, 1.0F)).level_weight(), 1.1F);
    EXPECT_FLOAT_EQ(started(adapting(0.5F, 0.2F)).level_weight(), 1.0F + 0.1F * 0.25F);
}

TEST(LoadAdaptation, ARestoredLoadIsDoubtedIfTheLoadMayHaveChanged) {
    rsi_test::LoadAdaptation adaptation = started();
    ASSERT_TRUE(adaptation.restore({0.4F, 0.03F, 0.2F}, false));
    EXPECT_EQ(adaptation.learnt().excess, 0.4F);
    EXPECT_FLOAT_EQ(adaptation.learnt().excess_deviation, 0.03F);
    EXPECT_EQ(adaptation.learnt().offset_mps2, 0.2F);
    ASSERT_TRUE(adaptation.restore({0.4F, 0.03F, 0.2F}, true));
    EXPECT_FLOAT_EQ(adaptation.learnt().excess, 0.2F);
    EXPECT_GT(adaptation.learnt().excess_deviation, 0.15F);
    EXPECT_EQ(adaptation.learnt().offset_mps2, 0.2F);
    EXPECT_FALSE(adaptation.restore({nan, 0.03F, 0.2F}, true));
    EXPECT_FLOAT_EQ(adaptation.learnt().excess, 0.2F);
}

// The component with a vehicle that carries a load.
class LoadedScenario {
 public:
    explicit LoadedScenario(double excess, float share = 1.0F)
        : course_{rsi_test::large_suv(), loaded_by(excess)} {
        EXPECT_EQ(component_.init(adapting(share)).accepted, 1);
    }
    rsi::Component& component() { return component_; }
    const rsi_outputs& outputs() const { return outputs_; }

    void drive(int samples) {
        for (int k = 0; k < samples; ++k) {
            course_.advance();
            component_.step(course_.inputs(speed_mps), outputs_);
        }
    }
    void lose_the_sensors(int samples) {
        rsi_inputs none{};
        none.lateral_specific_force_mps2 = nan;
        for (int k = 0; k < samples; ++k) {
            component_.step(none, outputs_);
        }
    }
    // In one and the same turn of the loaded vehicle.
    const rsi_outputs& turn(double force_mps2, double roll_angle_rad) {
        rsi_test::GroundMotion motion;
        motion.lateral_acceleration_mps2 = force_mps2;
        motion.roll_angle_rad = roll_angle_rad;
        rsi_inputs inputs = rsi_test::sensed(motion);
        inputs.speed_mps = static_cast<float>(speed_mps);
        for (int k = 0; k < 200; ++k) {
            component_.step(inputs, outputs_);
        }
        return outputs_;
    }

 private:
    LoadedDrive course_;
    rsi::Component component_{};
    rsi_outputs outputs_{};
};

TEST(LoadOfTheComponent, IsPublished) {
    LoadedScenario scenario{0.4};
    scenario.drive(samples_in_two_minutes);
    EXPECT_NEAR(scenario.outputs().load_excess, 0.4F, 0.05F);
    EXPECT_LT(scenario.outputs().load_excess_deviation, 0.05F);
    EXPECT_EQ(scenario.outputs().load_excess, scenario.component().learnt_load().excess);
}

// A load lowers the threshold and raises what the same turn means.
TEST(LoadOfTheComponent, MovesThresholdLoadTransferAndPrediction) {
    LoadedScenario off{0.4, 0.0F};
    LoadedScenario on{0.4, 1.0F};
    off.drive(samples_in_two_minutes);
    on.drive(samples_in_two_minutes);
    EXPECT_EQ(off.outputs().load_excess, on.outputs().load_excess);
    const rsi_outputs empty = off.turn(5.0, 0.1);
    const rsi_outputs loaded = on.turn(5.0, 0.1);
    EXPECT_LT(loaded.lateral_acceleration_threshold_mps2, empty.lateral_acceleration_threshold_mps2 - 0.3F);
    EXPECT_GT(loaded.rsi_extended, 1.05F * empty.rsi_extended);
    EXPECT_NE(loaded.load_transfer_ratio, empty.load_transfer_ratio);
    EXPECT_NE(loaded.predicted_load_transfer_ratio, empty.predicted_load_transfer_ratio);
    EXPECT_EQ(loaded.energy_margin, empty.energy_margin);  // for comparison, as published
    EXPECT_EQ(loaded.static_stability_level, empty.static_stability_level);
}

// The roll-centre estimate is what is left when the load is known.
TEST(LoadOfTheComponent, IsNotTakenForAMovementOfTheRollCentre) {
    rsi_parameters parameters = adapting(1.0F);
    parameters.estimator = RSI_ESTIMATOR_CONSIDER_KALMAN;
    const auto largest_movement = [&parameters](float share) {
        parameters.load_adaptation = share;
        rsi::Component component;
        EXPECT_EQ(component.init(parameters).accepted, 1);
        LoadedDrive course(rsi_test::large_suv(), loaded_by(0.4));
        float largest = 0.0F;
        for (int k = 0; k < 2 * samples_in_two_minutes; ++k) {
            course.advance();
            rsi_outputs outputs{};
            component.step(course.inputs(speed_mps), outputs);
            if (k > samples_in_two_minutes) {
                largest = std::fmax(largest, std::fabs(outputs.roll_centre_vertical_m));
            }
        }
        return largest;
    };
    EXPECT_GT(largest_movement(0.0F), 0.1F);
    EXPECT_LT(largest_movement(1.0F), 0.06F);
}

TEST(LoadOfTheComponent, SurvivesAGapInTheInputs) {
    LoadedScenario scenario{0.4};
    scenario.drive(samples_in_two_minutes);
    const rsi::LearntLoad before = scenario.component().learnt_load();
    scenario.lose_the_sensors(1000);
    EXPECT_EQ(scenario.component().learnt_load().excess, before.excess);
    EXPECT_TRUE(std::isnan(scenario.outputs().load_excess));
    scenario.drive(1);
    EXPECT_NEAR(scenario.outputs().load_excess, before.excess, 0.01F);
}

TEST(LoadOfTheComponent, IsForgottenByAnOverturn) {
    LoadedScenario scenario{0.4};
    scenario.drive(samples_in_two_minutes);
    scenario.turn(0.0, 1.4);
    scenario.turn(0.0, 0.0);
    EXPECT_EQ(scenario.component().learnt_load().excess, 0.0F);
    EXPECT_EQ(scenario.component().learnt_load().excess_deviation, 0.25F);
}

TEST(LoadOfTheComponent, IsRestoredAfterAStartAndForgottenByOne) {
    LoadedScenario scenario{0.4};
    scenario.drive(samples_in_two_minutes);
    const rsi::LearntLoad kept = scenario.component().learnt_load();
    ASSERT_EQ(scenario.component().init(adapting()).accepted, 1);
    EXPECT_EQ(scenario.component().learnt_load().excess, 0.0F);
    ASSERT_TRUE(scenario.component().restore_load(kept, true));
    EXPECT_FLOAT_EQ(scenario.component().learnt_load().excess, 0.5F * kept.excess);
    ASSERT_TRUE(scenario.component().restore_load(kept, false));
    EXPECT_EQ(scenario.component().learnt_load().excess, kept.excess);
    EXPECT_FALSE(scenario.component().restore_load({2.0F, 0.1F, 0.0F}, false));
    rsi::Component refused;
    EXPECT_FALSE(refused.restore_load(kept, true));
}

}  // namespace
}  // namespace load_adaptation_test
