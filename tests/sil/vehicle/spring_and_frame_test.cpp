// Dry friction, progression and a frame that twists, seen from a tilt table and from the spring's force.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scenario.hpp"
#include "sil/world/vehicle/suspension.hpp"

namespace {

using scenario::degree;

struct Tilted {
    double angle_rad{0.0};
    double roll_rad{0.0};  // of the body against the table
};

// Slowly from level to `angle_rad`, and back if `and_back`.
std::vector<Tilted> tilted(const sil::VehicleParameters& parameters, double angle_rad, bool and_back) {
    scenario::TiltTable table;
    sil::Vehicle vehicle{parameters, table};
    std::vector<Tilted> course;
    const double rate_radps = 1.0 * degree;
    const double way_s = angle_rad / rate_radps;
    for (double time_s = 0.0; time_s < (and_back ? 2.0 : 1.0) * way_s; time_s += 0.001) {
        const double angle = rate_radps * (way_s - std::abs(way_s - time_s));
        table.tilt_to(angle);
        vehicle.step({});
        course.push_back({angle, vehicle.truth().roll_angle_rad});
    }
    return course;
}

// Roll half-way down less roll half-way up.
double loop_rad(const sil::VehicleParameters& parameters) {
    const std::vector<Tilted> course = tilted(parameters, 20.0 * degree, true);
    return course[course.size() * 3U / 4U].roll_rad - course[course.size() / 4U].roll_rad;
}

TEST(DryFriction, MakesALoopInRollThatItsSizeWidens) {
    sil::VehicleParameters parameters = scenario::van();
    const double smooth = loop_rad(parameters);
    EXPECT_LT(std::abs(smooth), 0.1 * degree) << "dampers, at a degree a second";
    double narrower = std::abs(smooth);
    for (const double friction : {0.02, 0.05, 0.08}) {
        parameters.front_suspension.spring_damper.dry_friction = friction;
        parameters.rear_suspension.spring_damper.dry_friction = friction;
        const double loop = loop_rad(parameters);
        EXPECT_GT(loop, narrower + 0.02 * degree) << friction;
        narrower = loop;
    }
}

TEST(DryFriction, NearsItsLargestForceWithTheWayAndNotWithTheSpeed) {
    using Unit = sil::BasicSpringDamper<double>;
    sil::SpringDamperParameters spring;
    spring.dry_friction = 0.05;
    const Unit unit{spring, 4000.0};
    double slow = 0.0;
    for (int step = 0; step < 10000; ++step) {
        slow = Unit::rubbed_share(slow, 0.01 / 10000.0);
    }
    double fast = 0.0;
    for (int step = 0; step < 1000; ++step) {
        fast = Unit::rubbed_share(fast, 0.01 / 1000.0);
    }
    EXPECT_NEAR(fast, slow, 0.01);
    EXPECT_GT(unit.friction_force_n(slow), 0.9 * 200.0);
    EXPECT_LE(unit.friction_force_n(slow), 200.0);
    EXPECT_LT(Unit::rubbed_share(slow, -0.01), 0.0) << "turned around, it soon acts the other way";
    EXPECT_GE(Unit::rubbed_share(0.0, -1.0e6), -1.0);
}

TEST(Progression, StiffensTheSpringAndIsItsEnergysSlope) {
    sil::SpringDamperParameters linear;
    linear.spring_npm = 30.0e3;
    linear.jounce_clearance_m = linear.rebound_clearance_m = 1.0;
    sil::SpringDamperParameters progressive = linear;
    progressive.progression_pm2 = 100.0;
    const sil::BasicSpringDamper<double> plain{linear, 4000.0};
    const sil::BasicSpringDamper<double> unit{progressive, 4000.0};
    const double apart = 1.0e-4;
    for (const double q : {-0.08, -0.03, 0.0, 0.03, 0.08}) {
        const double stiffness =
            (unit.elastic_force_n(q + apart) - unit.elastic_force_n(q - apart)) / (2.0 * apart);
        EXPECT_NEAR(stiffness, 30.0e3 * (1.0 + 100.0 * q * q), 1.0);
        const double slope =
            (unit.stored_energy_j(q + apart) - unit.stored_energy_j(q - apart)) / (2.0 * apart);
        EXPECT_NEAR(slope, unit.elastic_force_n(q), 0.1);
    }
    EXPECT_EQ(unit.elastic_force_n(0.0), plain.elastic_force_n(0.0));
}

TEST(Progression, LetsTheBodyRollLess) {
    sil::VehicleParameters parameters = scenario::van();
    const double linear = tilted(parameters, 12.0 * degree, false).back().roll_rad;
    parameters.front_suspension.spring_damper.progression_pm2 = 150.0;
    parameters.rear_suspension.spring_damper.progression_pm2 = 150.0;
    EXPECT_LT(tilted(parameters, 12.0 * degree, false).back().roll_rad, 0.99 * linear);
}

struct Lifting {
    double front_rad{0.0};  // angle of the table at which the left front wheel lifts
    double rear_rad{0.0};
    double roll_rad{0.0};  // of the body at eight degrees
};

Lifting lifting(const sil::VehicleParameters& parameters) {
    scenario::TiltTable table;
    sil::Vehicle vehicle{parameters, table};
    Lifting seen;
    for (int step = 0; step < 50000 && (seen.front_rad == 0.0 || seen.rear_rad == 0.0); ++step) {
        const double angle_rad = step * 0.001 * degree;
        table.tilt_to(angle_rad);
        vehicle.step({});
        const sil::Truth& truth = vehicle.truth();
        if (angle_rad < 8.0 * degree) {
            seen.roll_rad = truth.roll_angle_rad;
        }
        if (seen.front_rad == 0.0 && truth.wheel_load_n[sil::front_left] <= 0.0) {
            seen.front_rad = angle_rad;
        }
        if (seen.rear_rad == 0.0 && truth.wheel_load_n[sil::rear_left] <= 0.0) {
            seen.rear_rad = angle_rad;
        }
    }
    return seen;
}

TEST(TwistingFrame, LiftsTheWheelsOfOnePartFirstAndRollsTheOtherLess) {
    const Lifting rigid = lifting(scenario::van());
    sil::VehicleParameters parameters = scenario::twisting(scenario::van(), 5.0e3);
    parameters.rear_suspension.frame_rear_share = 0.65;
    const Lifting soft = lifting(parameters);
    // The van's front is the stiffer one and lets go first, until the rear has most of the mass for itself.
    // The sensors, in front, then see less roll.
    EXPECT_LT(rigid.front_rad, rigid.rear_rad - 1.0 * degree);
    EXPECT_LT(soft.rear_rad, soft.front_rad - 1.0 * degree);
    EXPECT_LT(soft.rear_rad, rigid.rear_rad - 0.5 * degree);
    EXPECT_LT(soft.roll_rad, 0.9 * rigid.roll_rad);
}

TEST(TwistingFrame, IsTheRigidOneIfStiff) {
    const Lifting rigid = lifting(scenario::van());
    sil::VehicleParameters parameters = scenario::twisting(scenario::van(), 100.0e6);
    const Lifting stiff = lifting(parameters);
    EXPECT_NEAR(stiff.front_rad, rigid.front_rad, 0.02 * degree);
    EXPECT_NEAR(stiff.rear_rad, rigid.rear_rad, 0.02 * degree);
    EXPECT_NEAR(stiff.roll_rad, rigid.roll_rad, 0.002 * degree);

    parameters.rear_suspension.frame_rear_share = 0.0;
    const Lifting nothing_behind = lifting(parameters);
    EXPECT_EQ(nothing_behind.front_rad, rigid.front_rad) << "nothing turns, and the bits are those of before";
    EXPECT_EQ(nothing_behind.roll_rad, rigid.roll_rad);
}

}  // namespace
