// Mixed driving: the ordinary driver gets the accelerations that are wanted, and keeps to them.
#include "sil/world/manoeuvres/mixed_driving.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenario.hpp"

namespace {

struct Extremes {
    double lateral_g{0.0};
    double forward_g{0.0};
    double slowest_mps{100.0};
    double fastest_mps{0.0};
};

// Braking and accelerating is told from the speed, so that what a turn takes of it counts too.
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

TEST(MixedDriving, TurnsHardNowAndThen) {
    EXPECT_GT(driven(scenario::large_suv(), sil::mixed_driving(3U, 180.0)).lateral_g, 0.5);
}

}  // namespace
