// Courses: bends that tighten and crowned roads, followed by a driver who looks ahead.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenario.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/path_driver.hpp"

namespace course_test {
namespace {

TEST(DecreasingRadius, AsksForMoreThanTwiceAsMuchOnceItHasTightened) {
    sil::ManoeuvreRun run{scenario::ordinary_suv(), sil::find_manoeuvre("decreasing-radius")};
    double wide = 0.0;
    double tight = 0.0;
    while (!run.finished()) {
        run.step();
        double& largest = run.truth().time_s < 4.5 ? wide : tight;
        largest = std::max(largest, run.truth().lateral_acceleration_mps2);
    }
    EXPECT_GT(wide, 2.0);
    EXPECT_GT(tight, 1.5 * wide);
}

TEST(CrownedRoad, IsCrossedOutAndBack) {
    sil::ManoeuvreRun run{scenario::ordinary_suv(), sil::find_manoeuvre("crowned-road")};
    double most_left_m = 0.0;
    double least_bank = 1.0;
    EXPECT_GT(run.truth().bank_angle_rad, 0.015);
    while (!run.finished()) {
        run.step();
        most_left_m = std::max(most_left_m, run.truth().position_y_m);
        least_bank = std::min(least_bank, run.truth().bank_angle_rad);
    }
    EXPECT_GT(most_left_m, 3.0);
    EXPECT_LT(most_left_m, 4.5);
    EXPECT_LT(least_bank, -0.015);
    EXPECT_NEAR(run.truth().position_y_m, 0.0, 0.5);
}

TEST(Course, IsMadeOfStraightsBendsAndChangesOfLane) {
    const double radius_m = 20.0;
    const sil::Course course =
        sil::Course{}.straight(10.0).bend(0.5 * 3.14159265358979 * radius_m, 1.0 / radius_m, 1.0 / radius_m);
    EXPECT_NEAR(course.points().back().x_m, 10.0 + radius_m, 0.3);
    EXPECT_NEAR(course.points().back().y_m, radius_m, 0.3);
    const sil::Course lane = sil::Course{}.straight(10.0).change_lane(30.0, -3.5).straight(10.0);
    EXPECT_NEAR(lane.points().back().x_m, 50.0, 1e-9);
    EXPECT_NEAR(lane.points().back().y_m, -3.5, 1e-9);
}

// The firmware takes a faster hand for a fault of the sensor.
TEST(PathDriver, TurnsTheHandwheelNoFasterThanAPersonDoes) {
    for (const char* name : {"decreasing-radius", "crowned-road"}) {
        sil::RunOptions options;
        options.speed_factor = 1.4;  // too fast for the course
        sil::ManoeuvreRun run{scenario::large_suv(), sil::find_manoeuvre(name), options};
        double before = 0.0;
        double fastest = 0.0;
        while (!run.finished()) {
            run.step();
            fastest = std::max(fastest, std::abs(run.truth().steering_wheel_angle_rad - before) / 0.001);
            before = run.truth().steering_wheel_angle_rad;
        }
        EXPECT_LE(fastest, sil::from_degrees(721.0)) << name;
        EXPECT_GT(fastest, 1.0) << name;
    }
}

}  // namespace
}  // namespace course_test
