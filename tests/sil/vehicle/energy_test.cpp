// Energy: none is made from nothing. A road without friction leaves springs, masses and dampers alone.
#include <gtest/gtest.h>
#include <cmath>

#include "scenario.hpp"

namespace {

const sil::PlaneRoad& ice() {
    static const sil::PlaneRoad road{0.0, 0.0};
    return road;
}

sil::InitialState disturbance() {
    sil::InitialState initial;
    initial.height_offset_m = 0.04;
    initial.roll_offset_rad = 0.06;
    initial.pitch_offset_rad = 0.02;
    initial.roll_rate_radps = 0.4;
    return initial;
}

sil::VehicleParameters rubbing(sil::VehicleParameters parameters) {
    parameters.front_suspension.spring_damper.dry_friction = 0.05;
    parameters.rear_suspension.spring_damper.dry_friction = 0.05;
    return parameters;
}

// Largest change of energy over three seconds, as a share of what the disturbance brought in.
double energy_drift(const sil::VehicleParameters& parameters, double step_s) {
    sil::Vehicle vehicle{parameters, ice()};
    const double at_rest = vehicle.mechanical_energy_j();
    vehicle.reset(disturbance());
    const double start = vehicle.mechanical_energy_j();
    double largest = 0.0;
    for (double time_s = 0.0; time_s < 3.0; time_s += step_s) {
        vehicle.step({}, step_s);
        largest = std::max(largest, std::abs(vehicle.mechanical_energy_j() - start));
    }
    return largest / (start - at_rest);
}

TEST(Energy, NeverGrowsInFreeDecayWithDampersOn) {
    for (const sil::VehicleParameters& parameters :
         {scenario::large_suv(), scenario::ordinary_suv(), rubbing(scenario::ordinary_suv()),
          scenario::twisting(rubbing(scenario::van()), 30.0e3)}) {
        sil::Vehicle vehicle{parameters, ice()};
        const double at_rest = vehicle.mechanical_energy_j();
        vehicle.reset(disturbance());
        double before = vehicle.mechanical_energy_j();
        const double brought_in = before - at_rest;
        ASSERT_GT(brought_in, 100.0);
        for (int step = 0; step < 5000; ++step) {
            vehicle.step({});
            const double now = vehicle.mechanical_energy_j();
            // Semi-implicit Euler lets energy ripple by the step's order; a tenth of a per mille is rounding
            // of that kind, a wrong force would make a hundred times more.
            ASSERT_LT(now, before + 1e-4 * brought_in) << "step " << step;
            before = now;
        }
        EXPECT_LT(before - at_rest, 0.01 * brought_in);
    }
}

TEST(Energy, IsKeptWithoutDampersUpToAnErrorThatShrinksWithTheStep) {
    const sil::VehicleParameters parameters = scenario::undamped(scenario::large_suv());
    EXPECT_LT(energy_drift(parameters, 1.0 / 1000.0), 0.05);
    EXPECT_LT(energy_drift(parameters, 1.0 / 4000.0), 0.0125);
    EXPECT_LT(energy_drift(parameters, 1.0 / 16000.0), 0.0031);
}

TEST(Energy, IsKeptByProgressiveSpringsAndAFrameThatTwists) {
    sil::VehicleParameters parameters = scenario::undamped(scenario::twisting(scenario::large_suv(), 40.0e3));
    parameters.rear_suspension.frame_damping_nmsprad = 0.0;
    parameters.front_suspension.spring_damper.progression_pm2 = 150.0;
    parameters.rear_suspension.spring_damper.progression_pm2 = 150.0;
    EXPECT_LT(energy_drift(parameters, 1.0 / 1000.0), 0.05);
    EXPECT_LT(energy_drift(parameters, 1.0 / 4000.0), 0.0125);
    EXPECT_LT(energy_drift(parameters, 1.0 / 16000.0), 0.0031);
}

// Without dampers only the friction is left: it takes energy in every step, and what it cannot move stays.
TEST(Energy, IsTakenByDryFriction) {
    const sil::VehicleParameters parameters = scenario::undamped(rubbing(scenario::large_suv()));
    sil::Vehicle vehicle{parameters, ice()};
    const double at_rest = vehicle.mechanical_energy_j();
    vehicle.reset(disturbance());
    const double brought_in = vehicle.mechanical_energy_j() - at_rest;
    double before = brought_in;
    for (int second = 0; second < 3; ++second) {
        for (int step = 0; step < 1000; ++step) {
            vehicle.step({});
        }
        const double now = vehicle.mechanical_energy_j() - at_rest;
        EXPECT_LT(now, 0.9 * before) << "second " << second;
        before = now;
    }
    EXPECT_LT(before, 0.3 * brought_in);
}

TEST(Energy, IsKeptWhileTumblingThroughTheAir) {
    sil::VehicleParameters parameters = scenario::undamped(scenario::large_suv());
    parameters.aerodynamics.drag_area_m2 = 0.0;
    sil::Vehicle vehicle{parameters, ice()};
    sil::InitialState thrown;
    thrown.height_offset_m = 12.0;
    thrown.roll_rate_radps = 3.0;
    thrown.pitch_rate_radps = -1.0;
    thrown.yaw_rate_radps = 2.0;
    thrown.speed_mps = 10.0;
    vehicle.reset(thrown);
    const double start = vehicle.mechanical_energy_j();
    const double step_s = 1.0 / 16000.0;
    for (int step = 0; step < 16000; ++step) {
        vehicle.step({}, step_s);
        ASSERT_NEAR(vehicle.mechanical_energy_j(), start, 8.0);  // of some 5 kJ in rotation
    }
    EXPECT_GT(std::abs(vehicle.truth().roll_angle_rad), 1.0);
}

// Turning left, the wheels' spin adds a roll moment outwards of yaw rate times angular momentum.
TEST(Energy, SpinningWheelsRollAYawingVehicleOutwards) {
    const sil::VehicleParameters parameters = scenario::symmetric(scenario::large_suv());
    const auto roll_acceleration = [&parameters](double speed_mps) {
        sil::Vehicle vehicle{parameters, ice()};
        sil::InitialState initial;
        initial.speed_mps = speed_mps;
        initial.yaw_rate_radps = 0.5;
        vehicle.reset(initial);
        return vehicle.truth().angular_acceleration_radps2[0];
    };
    const double added = roll_acceleration(30.0) - roll_acceleration(0.0);
    const double moment =
        4.0 * parameters.inertia.wheel_spin_kgm2 * (30.0 / parameters.geometry.wheel_radius_m) * 0.5;
    // The roll inertia that resists is more than the body's own and less than twice that.
    EXPECT_LT(added, 1.1 * moment / parameters.inertia.sprung_roll_kgm2);
    EXPECT_GT(added, 0.5 * moment / parameters.inertia.sprung_roll_kgm2);
}

}  // namespace
