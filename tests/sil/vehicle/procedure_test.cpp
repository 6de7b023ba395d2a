// Procedures: each manoeuvre steers, brakes and drives as its standard or its description says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "scenario.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/rule_book.hpp"
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"
#include "sil/world/vehicle/load.hpp"

namespace {

constexpr double degrees_per_radian = 57.295779513082321;

struct Named {
    const char* name;
    sil::VehicleParameters parameters;
};

std::vector<Named> vehicles() {
    return {{"large SUV", scenario::large_suv()},
            {"ordinary SUV", scenario::ordinary_suv()},
            {"van", scenario::van()}};
}

std::vector<sil::Truth> truths(const sil::VehicleParameters& parameters, const std::string& name,
                               double duration_s = 0.0) {
    sil::RunOptions options;
    options.duration_s = duration_s;
    sil::ManoeuvreRun run{parameters, sil::find_manoeuvre(name), options};
    std::vector<sil::Truth> result{run.truth()};
    while (!run.finished()) {
        run.step();
        result.push_back(run.truth());
    }
    return result;
}

double handwheel_deg(const sil::Truth& truth) {
    return truth.steering_wheel_angle_rad * degrees_per_radian;
}

// The first moment from `from_s` on at which the condition holds.
double first_s(const std::vector<sil::Truth>& run, double from_s,
               const std::function<bool(const sil::Truth&)>& condition) {
    const auto found = std::find_if(run.begin(), run.end(), [&](const sil::Truth& truth) {
        return truth.time_s > from_s && condition(truth);
    });
    return found == run.end() ? scenario::not_yet : found->time_s;
}

TEST(SlowlyIncreasingSteer, GivesTheAngleAtWhichASteadyTurnHasAboutThreeTenths) {
    for (const Named& vehicle : vehicles()) {
        const double angle = sil::handwheel_angle_at_0_3_g_rad(vehicle.parameters);
        const auto turn = scenario::manoeuvre(80.4672, 20.0, [angle](double time_s) {
            return sil::DriverCommand{sil::ramp_and_hold(time_s, 1.0, 0.1, angle)};
        });
        // The ramp runs ahead of the vehicle by some tenths of a second, 13.5 degrees each second.
        const double steady_g = scenario::drive(vehicle.parameters, turn).final_ay_g;
        EXPECT_GT(steady_g, 0.295) << vehicle.name;
        EXPECT_LT(steady_g, 0.36) << vehicle.name;
    }
}

TEST(SlowlyIncreasingSteer, RampsAtThirteenAndAHalfDegreesPerSecondAndHoldsFiftyMilesPerHour) {
    const std::vector<sil::Truth> run = truths(scenario::large_suv(), "slowly-increasing-steer");
    for (const sil::Truth& truth : run) {
        ASSERT_NEAR(handwheel_deg(truth), std::clamp(13.5 * (truth.time_s - 1.0), 0.0, 270.0), 0.02);
        ASSERT_NEAR(truth.speed_mps, 50.0 * 0.44704, 0.5);
    }
    EXPECT_NEAR(run.back().time_s, 23.0, 1e-6);
}

TEST(SlowlyIncreasingSteer, OnIceThereIsNoAngleAndAnErrorSaysSo) {
    sil::VehicleParameters parameters = scenario::ordinary_suv();
    parameters.tyre.friction *= 0.1;
    try {
        sil::handwheel_angle_at_0_3_g_rad(parameters);
        FAIL() << "no error";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string{error.what()}.find("ordinary SUV"), std::string::npos);
    }
}

TEST(SlowlyIncreasingSteer, GivesAVehicleThatSlidesBeforeTheEndOfTheFitTheAngleAtWhichItReachesThreeTenths) {
    const sil::VehicleParameters sliding = sil::with_friction(scenario::large_suv(), 0.42);
    double reached_deg = 0.0, largest_mps2 = 0.0;
    for (const sil::Truth& truth : truths(sliding, "slowly-increasing-steer")) {
        largest_mps2 = std::max(largest_mps2, truth.lateral_acceleration_mps2);
        if (reached_deg == 0.0 && truth.lateral_acceleration_mps2 > 0.3 * sil::gravity_mps2) {
            reached_deg = handwheel_deg(truth);
        }
    }
    ASSERT_GT(largest_mps2, 0.3 * sil::gravity_mps2);
    ASSERT_LT(largest_mps2, 0.375 * sil::gravity_mps2);
    EXPECT_NEAR(sil::handwheel_angle_at_0_3_g_rad(sliding) * degrees_per_radian, reached_deg, 1.0);
}

sil::VehicleParameters on_ice() {
    return sil::with_friction(scenario::large_suv(), 0.02);
}

TEST(SlowlyIncreasingSteer, FoundAheadForSeveralVehiclesIsThatOfEachAlone) {
    std::vector<sil::VehicleParameters> all;
    for (const Named& vehicle : vehicles()) {
        for (const double load_kg : {0.0, 50.0, 150.0, 300.0}) {
            all.push_back(sil::with_load(vehicle.parameters, load_kg, 1.0));
        }
    }
    std::vector<double> alone_rad;
    std::vector<const sil::VehicleParameters*> pointers;
    for (const sil::VehicleParameters& vehicle : all) {
        alone_rad.push_back(sil::handwheel_angle_at_0_3_g_rad(vehicle));
        pointers.push_back(&vehicle);
    }
    const sil::VehicleParameters ice = on_ice();
    pointers.insert(pointers.begin() + 2, &ice);
    const double mirrored_rad = sil::handwheel_angle_at_0_3_g_rad(all[0], true);
    sil::find_handwheel_angles_ahead(pointers);
    for (std::size_t i = 0U; i < all.size(); ++i) {
        EXPECT_EQ(sil::handwheel_angle_at_0_3_g_rad(all[i]), alone_rad[i]) << i;
    }
    EXPECT_EQ(sil::handwheel_angle_at_0_3_g_rad(all[0], true), mirrored_rad);
    EXPECT_THROW(sil::handwheel_angle_at_0_3_g_rad(ice), std::runtime_error);
    sil::find_handwheel_angles_ahead({});
    EXPECT_EQ(sil::handwheel_angle_at_0_3_g_rad(all[1]), alone_rad[1]);
}

// On ice there is no such angle, so who asks for it cannot begin.
TEST(AllManoeuvres, SayWhetherTheyAskForTheHandwheelAngle) {
    for (const sil::Manoeuvre& manoeuvre : sil::all_manoeuvres()) {
        if (manoeuvre.asks_for_handwheel_angle) {
            EXPECT_THROW((sil::ManoeuvreRun{on_ice(), manoeuvre}), std::runtime_error) << manoeuvre.name;
        } else {
            EXPECT_NO_THROW((sil::ManoeuvreRun{on_ice(), manoeuvre})) << manoeuvre.name;
        }
    }
}

TEST(Fishhook1a, SteersDwellsAndCounterSteersAsNhtsaSays) {
    for (const Named& vehicle : vehicles()) {
        const double amplitude =
            6.5 * sil::handwheel_angle_at_0_3_g_rad(vehicle.parameters) * degrees_per_radian;
        const std::vector<sil::Truth> run = truths(vehicle.parameters, "fishhook-1a");
        const double ramp_s = amplitude / 720.0;
        for (const sil::Truth& truth : run) {
            const double since_s = truth.time_s - 2.0;
            const double first = std::clamp(720.0 * since_s, 0.0, amplitude);
            const double second = std::clamp(720.0 * (since_s - ramp_s - 0.25), 0.0, 2.0 * amplitude);
            const double back = std::clamp(amplitude / 2.0 * (since_s - 3.0 * ramp_s - 3.25), 0.0, amplitude);
            ASSERT_NEAR(handwheel_deg(truth), first - second + back, 2.0)
                << vehicle.name << " " << truth.time_s;
        }
        EXPECT_NEAR(run[1900].speed_mps, 88.0 / 3.6, 0.1) << vehicle.name;
        EXPECT_LT(run[2500].speed_mps, run[1900].speed_mps) << vehicle.name;
    }
}

TEST(Fishhook1b, ReversesWhenTheBodyHasStoppedRolling) {
    for (const Named& vehicle : vehicles()) {
        const double amplitude = 6.5 * sil::handwheel_angle_at_0_3_g_rad(vehicle.parameters);
        const std::vector<sil::Truth> run = truths(vehicle.parameters, "fishhook-1b", 4.0);
        const double full_s = 2.0 + amplitude / sil::from_degrees(720.0);
        const double small_s = first_s(run, full_s - 0.0005, [](const sil::Truth& truth) {
            return std::abs(truth.angular_velocity_radps[0]) <= sil::from_degrees(1.5);
        });
        const double reversed_s = first_s(run, full_s + 0.002, [&](const sil::Truth& truth) {
            return truth.steering_wheel_angle_rad < amplitude - 1e-9;
        });
        ASSERT_NE(small_s, scenario::not_yet) << vehicle.name;
        EXPECT_GT(small_s, full_s + 0.02) << vehicle.name;  // the body was rolling when the ramp ended
        EXPECT_NEAR(reversed_s, small_s, 0.0025) << vehicle.name;
    }
}

TEST(SineWithDwell, HasItsFrequencyItsDwellAndAtLeastTwoHundredAndSeventyDegrees) {
    const std::vector<sil::Truth> run = truths(scenario::large_suv(), "sine-with-dwell");
    EXPECT_NEAR(handwheel_deg(run[2000 + 357]), 270.0, 0.1);    // a quarter of 1 / 0.7 Hz
    EXPECT_NEAR(handwheel_deg(run[2000 + 714]), 0.0, 2.0);      // half
    EXPECT_NEAR(handwheel_deg(run[2000 + 1072]), -270.0, 0.1);  // three quarters
    EXPECT_NEAR(handwheel_deg(run[2000 + 1571]), -270.0, 0.1);  // and 0.5 s later
    EXPECT_GT(handwheel_deg(run[2000 + 1600]), -269.0);
    EXPECT_EQ(handwheel_deg(run[2000 + 1930]), 0.0);
}

TEST(StepSteer, GoesToAboutFourTenthsOnBothSidesWithoutLiftingAWheel) {
    for (const Named& vehicle : vehicles()) {
        const std::vector<sil::Truth> run = truths(vehicle.parameters, "step-steer");
        EXPECT_NEAR(run[4900].lateral_acceleration_mps2, 4.0, 0.6) << vehicle.name;
        EXPECT_NEAR(run[10900].lateral_acceleration_mps2, -4.0, 0.6) << vehicle.name;
        EXPECT_NEAR(run.back().lateral_acceleration_mps2, 0.0, 0.2) << vehicle.name;
        const scenario::Outcome outcome =
            scenario::drive(vehicle.parameters, sil::find_manoeuvre("step-steer"));
        EXPECT_EQ(outcome.one_wheel_lift_s, scenario::not_yet) << vehicle.name;
        EXPECT_LT(outcome.largest_load_transfer, 0.75) << vehicle.name;
    }
}

TEST(SlowRamp, IsSlowOnBothSidesAndGoesNearLiftOffWithoutReachingIt) {
    for (const Named& vehicle : vehicles()) {
        const std::vector<sil::Truth> run = truths(vehicle.parameters, "slow-ramp");
        double largest_left = 0.0;
        double largest_right = 0.0;
        for (const sil::Truth& truth : run) {
            const double transfer = scenario::load_transfer(truth);
            double& largest = truth.lateral_acceleration_mps2 > 0.0 ? largest_left : largest_right;
            largest = std::max(largest, transfer);
            ASSERT_NEAR(truth.speed_mps, 60.0 / 3.6, 0.5) << vehicle.name;
            for (const double load_n : truth.wheel_load_n) {
                ASSERT_GT(load_n, 0.0) << vehicle.name;
            }
        }
        EXPECT_GT(std::min(largest_left, largest_right), 0.7) << vehicle.name;
        EXPECT_LT(std::max(largest_left, largest_right), 0.85) << vehicle.name;
        EXPECT_EQ(handwheel_deg(run.back()), 0.0) << vehicle.name;
    }
}

void expect_inside(const sil::Truth& truth, const sil::HullParameters& hull,
                   const std::array<sil::LaneSection, 3>& track) {
    for (const double along : {hull.half_length_m, -hull.half_length_m}) {
        for (const double across : {hull.half_width_m, -hull.half_width_m}) {
            const double cosine = std::cos(truth.yaw_angle_rad);
            const double sine = std::sin(truth.yaw_angle_rad);
            const double x = truth.position_x_m + along * cosine - across * sine;
            const double y = truth.position_y_m + along * sine + across * cosine;
            for (const sil::LaneSection& section : track) {
                if (x >= section.begin_m && x <= section.end_m) {
                    ASSERT_GE(y, section.right_m) << x;
                    ASSERT_LE(y, section.left_m) << x;
                }
            }
        }
    }
}

TEST(DoubleLaneChange, KeepsAllCornersOfTheBodyWithinTheTrackOfTheStandard) {
    for (const Named& vehicle : vehicles()) {
        const sil::HullParameters& hull = vehicle.parameters.hull;
        const auto track = sil::lane_change_track(40.0, 2.0 * hull.half_width_m);
        double side_m = 0.0;
        for (const sil::Truth& truth : truths(vehicle.parameters, "double-lane-change")) {
            expect_inside(truth, hull, track);
            if (testing::Test::HasFatalFailure()) {
                FAIL() << vehicle.name << " at " << truth.time_s << " s";
            }
            side_m = std::max(side_m, truth.position_y_m);
            const bool before = truth.position_x_m < 41.9;
            ASSERT_TRUE(!before || std::abs(truth.speed_mps - 55.0 / 3.6) < 0.1);
        }
        EXPECT_GT(side_m, 2.9) << vehicle.name;  // really went to the other lane
    }
}

TEST(LaneChangeTrack, HasTheLengthsAndWidthsOfIso3888Part2) {
    const auto track = sil::lane_change_track(0.0, 1.8);
    EXPECT_NEAR(track[2].end_m, 61.0, 1e-9);
    EXPECT_NEAR(track[0].left_m - track[0].right_m, 1.1 * 1.8 + 0.25, 1e-12);
    EXPECT_NEAR(track[1].left_m - track[1].right_m, 2.8, 1e-12);
    EXPECT_NEAR(track[2].left_m - track[2].right_m, 3.0, 1e-12);
    EXPECT_NEAR(track[1].right_m - track[0].left_m, 1.0, 1e-12);
}

TEST(BrakingInTurn, BrakesHardOutOfASteadyTurnWithTheHandwheelHeld) {
    for (const Named& vehicle : vehicles()) {
        const std::vector<sil::Truth> run = truths(vehicle.parameters, "braking-in-turn");
        EXPECT_NEAR(run[6900].lateral_acceleration_mps2, 4.9, 0.5) << vehicle.name;
        EXPECT_EQ(handwheel_deg(run[6900]), handwheel_deg(run[9000])) << vehicle.name;
        const double deceleration = run[7500].speed_mps - run[8500].speed_mps;
        EXPECT_GT(deceleration, 3.5) << vehicle.name;
        EXPECT_LT(deceleration, 7.5) << vehicle.name;
    }
}

TEST(BankedStraight, HoldsTheLaneOnABankOfSixDegrees) {
    for (const Named& vehicle : vehicles()) {
        double largest_bank = 0.0;
        for (const sil::Truth& truth : truths(vehicle.parameters, "banked-straight")) {
            ASSERT_LT(std::abs(truth.position_y_m), 0.7) << vehicle.name;
            largest_bank = std::max(largest_bank, truth.bank_angle_rad);
            ASSERT_LT(scenario::load_transfer(truth), 0.3) << vehicle.name;
        }
        EXPECT_NEAR(largest_bank, sil::from_degrees(6.0), 1e-4) << vehicle.name;
    }
}

TEST(RoughRoad, ShakesTheVehicleWithoutLiftingAWheel) {
    for (const Named& vehicle : vehicles()) {
        const scenario::Outcome outcome =
            scenario::drive(vehicle.parameters, sil::find_manoeuvre("rough-road"));
        EXPECT_EQ(outcome.one_wheel_lift_s, scenario::not_yet) << vehicle.name;
        EXPECT_GT(outcome.largest_roll_deg, 0.5) << vehicle.name;
        EXPECT_LT(outcome.largest_load_transfer, 0.6) << vehicle.name;
    }
}

TEST(RoughTurn, ShakesTheVehicleInATurnWithoutLiftingASide) {
    for (const Named& vehicle : vehicles()) {
        const scenario::Outcome outcome =
            scenario::drive(vehicle.parameters, sil::find_manoeuvre("rough-turn"));
        EXPECT_EQ(outcome.two_wheel_lift_s, scenario::not_yet) << vehicle.name;
        EXPECT_GT(outcome.largest_ay_g, 0.3) << vehicle.name;
        EXPECT_LT(outcome.largest_load_transfer, 0.9) << vehicle.name;
    }
}

TEST(OneSidedBump, LiftsTheLeftWheelsAndNothingMore) {
    for (const Named& vehicle : vehicles()) {
        const std::vector<sil::Truth> run = truths(vehicle.parameters, "one-sided-bump");
        double highest_jounce = 0.0;
        for (const sil::Truth& truth : run) {
            ASSERT_LT(std::abs(truth.position_y_m), 0.2) << vehicle.name;
            ASSERT_LT(scenario::load_transfer(truth), 0.5) << vehicle.name;
            highest_jounce =
                std::max(highest_jounce, truth.suspension_deflection_m[0] - truth.suspension_deflection_m[1]);
        }
        EXPECT_GT(highest_jounce, 0.015) << vehicle.name;
    }
}

// The Panhard rod is all that tells left from right.
TEST(AllManoeuvres, MirroredAreTheMirrorImageForASymmetricVehicle) {
    const sil::VehicleParameters parameters = scenario::symmetric(scenario::large_suv());
    for (const sil::Manoeuvre& manoeuvre : sil::all_manoeuvres()) {
        sil::RunOptions options;
        options.duration_s = std::min(4.5, manoeuvre.duration_s);
        sil::ManoeuvreRun left{parameters, manoeuvre, options};
        options.mirrored = true;
        sil::ManoeuvreRun right{parameters, manoeuvre, options};
        while (!left.finished() && std::abs(left.truth().roll_angle_rad) < 0.5) {
            left.step();
            right.step();
            ASSERT_NEAR(left.truth().roll_angle_rad, -right.truth().roll_angle_rad, 1e-6)
                << manoeuvre.name << " at " << left.truth().time_s << " s";
            ASSERT_NEAR(left.truth().position_y_m, -right.truth().position_y_m, 1e-6) << manoeuvre.name;
        }
    }
}

TEST(AllManoeuvres, GiveTheSameResultEachTime) {
    for (const sil::Manoeuvre& manoeuvre : sil::all_manoeuvres()) {
        sil::RunOptions options;
        options.duration_s = 4.0;
        sil::ManoeuvreRun first{scenario::van(), manoeuvre, options};
        sil::ManoeuvreRun second{scenario::van(), sil::find_manoeuvre(manoeuvre.name), options};
        while (!first.finished()) {
            first.step();
            second.step();
        }
        EXPECT_EQ(first.truth().roll_angle_rad, second.truth().roll_angle_rad) << manoeuvre.name;
        EXPECT_EQ(first.truth().wheel_load_n, second.truth().wheel_load_n) << manoeuvre.name;
    }
}

TEST(AllManoeuvres, BeginAtRestOnTheirSuspensionAndStayFiniteForAllVehicles) {
    for (const Named& vehicle : vehicles()) {
        for (const sil::Manoeuvre& manoeuvre : sil::all_manoeuvres()) {
            sil::ManoeuvreRun run{vehicle.parameters, manoeuvre};
            const sil::VehicleParameters& adapted = run.vehicle().parameters();
            double sum_n = 0.0;
            for (const double load_n : run.truth().wheel_load_n) {
                sum_n += load_n;
            }
            EXPECT_NEAR(sum_n, sil::gravity_mps2 * sil::total_mass_kg(adapted), 0.01 * sum_n)
                << manoeuvre.name;
            EXPECT_NEAR(run.truth().speed_mps, manoeuvre.initial_speed_mps * manoeuvre.start_speed_share,
                        1e-6);
            while (!run.finished()) {
                run.step();
                ASSERT_TRUE(std::isfinite(run.truth().roll_angle_rad)) << vehicle.name << manoeuvre.name;
                ASSERT_TRUE(std::isfinite(run.truth().specific_force_mps2[1]))
                    << vehicle.name << manoeuvre.name;
            }
        }
    }
}

}  // namespace
