// Manoeuvres: found by name, and driven as they say.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "scenario.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"

namespace {

TEST(Catalogue, AnUnknownNameIsAnsweredWithThoseThatExist) {
    try {
        sil::find_manoeuvre("j-turn-111");
        FAIL() << "no error";
    } catch (const sil::UnknownManoeuvre& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("'j-turn-111'"), std::string::npos);
        for (const sil::Manoeuvre& manoeuvre : sil::all_manoeuvres()) {
            EXPECT_NE(message.find(manoeuvre.name), std::string::npos);
        }
    }
}

TEST(Catalogue, EveryManoeuvreHasItsOwnNameAndADescriptionOfOneLine) {
    std::set<std::string> names;
    for (const sil::Manoeuvre& manoeuvre : sil::all_manoeuvres()) {
        EXPECT_TRUE(names.insert(manoeuvre.name).second) << manoeuvre.name;
        EXPECT_EQ(sil::find_manoeuvre(manoeuvre.name).description, manoeuvre.description);
        EXPECT_FALSE(manoeuvre.description.empty());
        EXPECT_EQ(manoeuvre.description.find('\n'), std::string::npos);
        EXPECT_GT(manoeuvre.duration_s, 0.0);
    }
    for (const char* name : {"j-turn-110",
                             "j-turn-45",
                             "j-turn-banked",
                             "fishhook-1a",
                             "fishhook-1b",
                             "roll-centre-fixed",
                             "roll-centre-moving",
                             "slowly-increasing-steer",
                             "double-lane-change",
                             "slalom",
                             "sine-with-dwell",
                             "slow-ramp",
                             "step-steer",
                             "braking-in-turn",
                             "rough-turn",
                             "rough-road",
                             "banked-straight",
                             "one-sided-bump",
                             "straight",
                             "decreasing-radius",
                             "crowned-road",
                             "split-friction",
                             "gust",
                             "tyre-failure",
                             "sloshing-load",
                             "sliding-load",
                             "trailer",
                             "kerb-trip",
                             "soil-trip"}) {
        EXPECT_EQ(names.count(name), 1U) << name;
    }
}

TEST(ManoeuvreRun, LastsAsLongAsTheManoeuvreOrAsAsked) {
    sil::ManoeuvreRun whole{scenario::large_suv(), sil::find_manoeuvre("j-turn-110")};
    EXPECT_EQ(whole.duration_s(), sil::find_manoeuvre("j-turn-110").duration_s);
    sil::RunOptions options;
    options.duration_s = 0.25;
    sil::ManoeuvreRun run{scenario::large_suv(), sil::find_manoeuvre("straight"), options};
    int steps = 0;
    while (!run.finished()) {
        run.step();
        ++steps;
    }
    EXPECT_EQ(steps, 250);
}

TEST(ManoeuvreRun, ACopyGoesOnAsTheRunDoesWhateverTheDriverRemembers) {
    constexpr int until_the_copy = 1800;  // ms: most drivers have begun
    constexpr int after = 1500;
    for (const sil::Manoeuvre& manoeuvre : sil::all_manoeuvres()) {
        sil::ManoeuvreRun run{scenario::large_suv(), manoeuvre};
        for (int step = 0; step < until_the_copy; ++step) {
            run.step();
        }
        sil::ManoeuvreRun copy{run};
        for (int step = 0; step < after; ++step) {
            run.step();
        }
        ASSERT_NE(copy.truth().position_x_m, run.truth().position_x_m) << manoeuvre.name;
        for (int step = 0; step < after; ++step) {
            copy.step();
        }
        EXPECT_EQ(copy.truth().time_s, run.truth().time_s);
        EXPECT_EQ(copy.truth().position_x_m, run.truth().position_x_m) << manoeuvre.name;
        EXPECT_EQ(copy.truth().yaw_angle_rad, run.truth().yaw_angle_rad) << manoeuvre.name;
        EXPECT_EQ(copy.truth().wheel_load_n, run.truth().wheel_load_n) << manoeuvre.name;
    }
}

TEST(Straight, KeepsItsSpeedAndItsLane) {
    sil::ManoeuvreRun run{scenario::large_suv(), sil::find_manoeuvre("straight")};
    while (!run.finished()) {
        run.step();
        ASSERT_LT(std::abs(run.truth().lateral_acceleration_mps2), 0.05);
    }
    EXPECT_NEAR(run.truth().speed_mps, sil::from_kmh(100.0), 0.1);
    EXPECT_LT(std::abs(run.truth().position_y_m), 5.0);
}

TEST(Slalom, StaysWithinTheLimitsYetIsFirm) {
    const scenario::Outcome outcome = scenario::drive(scenario::large_suv(), sil::find_manoeuvre("slalom"));
    EXPECT_GT(outcome.largest_ay_g, 0.40);
    EXPECT_LT(outcome.largest_ay_g, 0.46);
    EXPECT_LT(outcome.largest_rsi, 0.70);
    EXPECT_EQ(outcome.one_wheel_lift_s, scenario::not_yet);
}

TEST(JTurn110, SteersAtTwoHundredAndFiftyDegreesPerSecondFromTheFirstSecondOn) {
    sil::ManoeuvreRun run{scenario::large_suv(), sil::find_manoeuvre("j-turn-110")};
    while (run.truth().time_s < 1.9995) {
        run.step();
        if (run.truth().time_s < 0.9995) {
            ASSERT_EQ(run.truth().steering_wheel_angle_rad, 0.0);
        }
    }
    EXPECT_NEAR(run.truth().steering_wheel_angle_rad, sil::from_degrees(250.0), sil::from_degrees(0.5));
    while (run.truth().time_s < 2.6) {
        run.step();
    }
    EXPECT_NEAR(run.truth().steering_wheel_angle_rad, sil::from_degrees(360.0), 1e-9);
}

}  // namespace
