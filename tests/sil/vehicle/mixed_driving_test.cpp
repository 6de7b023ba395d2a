// Mixed driving: the ordinary driver gets the accelerations that are wanted, and keeps to them.
#include "sil/world/manoeuvres/mixed_driving.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "scenario.hpp"

namespace {

struct Extremes {
    double lateral_g{0.0};
    double forward_g{0.0};
    double slowest_mps{100.0};
    double fastest_mps{0.0};
};

// Braking and accelerating is derived from the speed, so that what a turn takes of it counts too.
Extremes driven(const sil::VehicleParameters& vehicle, const sil::Manoeuvre& manoeuvre) {
    constexpr double moment_s = 0.5;
    sil::RunOptions options;
    options.duration_s = 180.0;
    sil::ManoeuvreRun run{vehicle, manoeuvre, options};
    Extremes most;
    double then_s = 0.0;
    double then_mps = run.truth().speed_mps;
    while (!run.finished()) {
        run.step();
        const sil::Truth& truth = run.truth();
        most.lateral_g =
            std::max(most.lateral_g, std::abs(truth.lateral_acceleration_mps2) / sil::gravity_mps2);
        most.slowest_mps = std::min(most.slowest_mps, truth.speed_mps);
        most.fastest_mps = std::max(most.fastest_mps, truth.speed_mps);
        if (truth.time_s > then_s + moment_s) {
            const double forward_mps2 = (truth.speed_mps - then_mps) / (truth.time_s - then_s);
            most.forward_g = std::max(most.forward_g, std::abs(forward_mps2) / sil::gravity_mps2);
            then_s = truth.time_s;
            then_mps = truth.speed_mps;
        }
    }
    return most;
}

TEST(OrdinaryDriving, TurnsAndChangesItsSpeedAsPeopleDo) {
    for (const sil::VehicleParameters& vehicle :
         {scenario::large_suv(), scenario::ordinary_suv(), scenario::van()}) {
        const Extremes most = driven(vehicle, sil::ordinary_driving(3U));
        EXPECT_GT(most.lateral_g, 0.3) << vehicle.name;
        EXPECT_LT(most.lateral_g, 0.5) << vehicle.name;
        EXPECT_LT(most.forward_g, 0.25) << vehicle.name;
        EXPECT_GT(most.fastest_mps - most.slowest_mps, 8.0) << vehicle.name;
    }
}

TEST(OrdinaryDriving, WithAShareOfTheAccelerationIsSoMuchCalmer) {
    const double whole = driven(scenario::van(), sil::ordinary_driving(3U)).lateral_g;
    const double half = driven(scenario::van(), sil::ordinary_driving(3U, 600.0, 0.5)).lateral_g;
    EXPECT_GT(half, 0.4 * whole);
    EXPECT_LT(half, 0.6 * whole);
}

// With less grip behind, the vehicle turns more than the wheel was turned for: who drives it feels that.
TEST(OrdinaryDriving, CorrectsAVehicleThatTurnsInMoreThanItWasThought) {
    sil::VehicleParameters sliding = scenario::ordinary_suv();
    sliding.tyre.rear_friction_factor *= 0.6;
    const Extremes most = driven(sliding, sil::ordinary_driving(3U));
    EXPECT_LT(most.lateral_g, 0.5);
}

// Hands that jump would be a fault of the steering sensor, and the firmware would rightly say so.
TEST(OrdinaryDriving, NeverTurnsTheWheelFasterThanHandsDo) {
    constexpr double fastest_radps = sil::from_degrees(500.0);
    const std::unique_ptr<sil::Driver> driver =
        sil::ordinary_driving(3U).make_driver(scenario::ordinary_suv());
    sil::Truth truth;
    truth.speed_mps = 5.0;
    double then_rad = 0.0;
    double to_the_left_radps = 0.0;
    double to_the_right_radps = 0.0;
    // The felt acceleration jumps to and fro once a second, so that a driver of endless hands would jump too.
    for (int step = 1; step < 6000; ++step) {
        constexpr double step_s = 0.01;
        truth.time_s = step * step_s;
        truth.lateral_acceleration_mps2 = (step / 100) % 2 == 0 ? 5.0 : -5.0;
        const double now_rad = driver->command(truth).steering_wheel_angle_rad;
        to_the_left_radps = std::max(to_the_left_radps, (now_rad - then_rad) / step_s);
        to_the_right_radps = std::max(to_the_right_radps, (then_rad - now_rad) / step_s);
        then_rad = now_rad;
    }
    EXPECT_NEAR(to_the_left_radps, fastest_radps, 1e-6);
    EXPECT_NEAR(to_the_right_radps, fastest_radps, 1e-6);
}

TEST(MixedDriving, TurnsHardNowAndThen) {
    EXPECT_GT(driven(scenario::large_suv(), sil::mixed_driving(3U, 180.0)).lateral_g, 0.5);
}

}  // namespace
