// Braking: load moves to the front by deceleration times height over wheelbase, and the vehicle stops.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "scenario.hpp"

namespace {

sil::Manoeuvre braking(double duration_s, double brake) {
    return scenario::manoeuvre(80.0, duration_s, [brake](double time_s) {
        return sil::DriverCommand{0.0, sil::SpeedPolicy::off_throttle, time_s > 0.5 ? brake : 0.0};
    });
}

TEST(Braking, TransfersLoadToTheFrontAxleAsTheDecelerationAndTheHeightOfTheCentreOfGravitySay) {
    for (sil::VehicleParameters parameters : {scenario::large_suv(), scenario::ordinary_suv()}) {
        parameters.aerodynamics.drag_area_m2 = 0.0;  // acts at another height
        sil::ManoeuvreRun run{parameters, braking(2.0, 0.4)};
        double speed_before_mps = 0.0;
        while (!run.finished()) {
            speed_before_mps = run.truth().speed_mps;
            run.step();
        }
        const sil::Truth& truth = run.truth();
        const auto& load = truth.wheel_load_n;
        const double deceleration = (speed_before_mps - truth.speed_mps) / sil::Vehicle::nominal_step_s;
        const double wheelbase =
            parameters.geometry.front_axle_to_cg_m + parameters.geometry.rear_axle_to_cg_m;
        const double transfer =
            load[sil::front_left] + load[sil::front_right] - scenario::front_axle_weight_n(parameters);
        ASSERT_GT(deceleration, 1.5);
        // Besides the deceleration, the dive carries the body's weight forward over the wheels.
        const double dive = parameters.mass.sprung_kg * sil::gravity_mps2 *
                            (parameters.geometry.cg_height_m - parameters.geometry.wheel_radius_m) *
                            std::sin(truth.pitch_angle_rad);
        const double overturning =
            sil::total_mass_kg(parameters) * deceleration * scenario::total_cg_height_m(parameters);
        EXPECT_NEAR(transfer, (overturning + dive) / wheelbase, 0.02 * transfer);
        EXPECT_GT(truth.pitch_angle_rad, 0.0) << "the nose should dive";
        EXPECT_GT(truth.suspension_deflection_m[sil::front_left], 0.0);
    }
}

TEST(Braking, CannotExceedTheFrictionOfTheTyres) {
    const sil::VehicleParameters parameters = scenario::large_suv();
    sil::ManoeuvreRun run{parameters, braking(2.0, 1.0)};
    double largest = 0.0;
    while (!run.finished()) {
        run.step();
        largest = std::max(largest, -run.truth().specific_force_mps2[0]);
    }
    EXPECT_GT(largest, 5.0);
    EXPECT_LT(largest, 1.15 * parameters.tyre.friction * sil::gravity_mps2);
}

TEST(Braking, BringsTheVehicleToRestAndKeepsItThere) {
    sil::ManoeuvreRun run{scenario::large_suv(), braking(12.0, 0.6)};
    while (!run.finished()) {
        run.step();
    }
    EXPECT_NEAR(run.truth().speed_mps, 0.0, 0.05);
    EXPECT_NEAR(run.truth().position_y_m, 0.0, 0.05);
    for (const double spin : run.truth().wheel_spin_radps) {
        EXPECT_NEAR(spin, 0.0, 0.2);
    }
}

// A driver who holds a speed that the friction does not give must not spin the wheels up: at 100 m/s they
// would be gyroscopes that tilt a turning vehicle.
TEST(Driving, DoesNotLetAnAxleRunAway) {
    sil::VehicleParameters parameters = scenario::large_suv();
    parameters.tyre.friction = 0.05;
    const sil::Manoeuvre held = scenario::manoeuvre(60.0, 8.0, [](double time_s) {
        return sil::DriverCommand{time_s > 0.5 ? 0.3 : 0.0, sil::SpeedPolicy::held, 0.0,
                                  time_s > 0.5 ? 2.0 : 1.0};
    });
    sil::ManoeuvreRun run{parameters, held};
    double most_mps = 0.0;
    while (!run.finished()) {
        run.step();
        const sil::Truth& truth = run.truth();
        const double slower_radps =
            std::min(truth.wheel_spin_radps[sil::rear_left], truth.wheel_spin_radps[sil::rear_right]);
        const double slip_mps =
            slower_radps * parameters.geometry.wheel_radius_m - std::fabs(truth.speed_mps);
        most_mps = std::max(most_mps, slip_mps);
        ASSERT_LT(slip_mps, 2.0 * (2.0 + 0.2 * std::fabs(truth.speed_mps)) + 1.0);
    }
    EXPECT_GT(most_mps, 2.0) << "the wheels should have spun";
}

}  // namespace
