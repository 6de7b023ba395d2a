// Load and friction: what a load does to mass, CG and inertia, and tyres that hold less.
#include "sil/world/vehicle/load.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <stdexcept>

#include "scenario.hpp"

namespace {

TEST(Load, KeepsMassFirstMomentAndInertiaAboutTheRoadConsistent) {
    const sil::VehicleParameters empty = scenario::large_suv();
    const sil::VehicleParameters loaded = sil::with_load(empty, 250.0, 1.9);
    EXPECT_NEAR(loaded.mass.sprung_kg, empty.mass.sprung_kg + 250.0, 1e-9);
    const auto first_moment = [](const sil::VehicleParameters& p) {
        return p.mass.sprung_kg * p.geometry.cg_height_m;
    };
    EXPECT_NEAR(first_moment(loaded), first_moment(empty) + 250.0 * 1.9, 1e-6);
    const auto about_road = [](const sil::VehicleParameters& p, double inertia) {
        return inertia + p.mass.sprung_kg * p.geometry.cg_height_m * p.geometry.cg_height_m;
    };
    EXPECT_NEAR(about_road(loaded, loaded.inertia.sprung_roll_kgm2),
                about_road(empty, empty.inertia.sprung_roll_kgm2) + 250.0 * 1.9 * 1.9, 1e-6);
    EXPECT_NEAR(about_road(loaded, loaded.inertia.sprung_pitch_kgm2),
                about_road(empty, empty.inertia.sprung_pitch_kgm2) + 250.0 * 1.9 * 1.9, 1e-6);
    EXPECT_EQ(loaded.inertia.sprung_yaw_kgm2, empty.inertia.sprung_yaw_kgm2);
    // Roof, floor and IMU stay where they were.
    EXPECT_NEAR(loaded.geometry.cg_height_m + loaded.hull.top_above_cg_m,
                empty.geometry.cg_height_m + empty.hull.top_above_cg_m, 1e-12);
    EXPECT_NEAR(loaded.geometry.cg_height_m - loaded.hull.bottom_below_cg_m,
                empty.geometry.cg_height_m - empty.hull.bottom_below_cg_m, 1e-12);
    EXPECT_NEAR(loaded.geometry.cg_height_m + loaded.imu_mount.z_m,
                empty.geometry.cg_height_m + empty.imu_mount.z_m, 1e-12);
}

TEST(Load, TakenOffAgainLeavesTheVehicleAsItWas) {
    const sil::VehicleParameters empty = scenario::ordinary_suv();
    const sil::VehicleParameters again = sil::with_load(sil::with_load(empty, 180.0, 1.6), -180.0, 1.6);
    EXPECT_NEAR(again.mass.sprung_kg, empty.mass.sprung_kg, 1e-9);
    EXPECT_NEAR(again.geometry.cg_height_m, empty.geometry.cg_height_m, 1e-12);
    EXPECT_NEAR(again.inertia.sprung_roll_kgm2, empty.inertia.sprung_roll_kgm2, 1e-9);
}

TEST(Load, IsCarriedByTheTyresOfAVehicleAtRest) {
    const sil::VehicleParameters loaded = sil::with_load(scenario::large_suv(), 300.0, 2.0);
    const sil::PlaneRoad road;
    const sil::Vehicle vehicle{loaded, road};
    double sum_n = 0.0;
    for (const double load_n : vehicle.truth().wheel_load_n) {
        sum_n += load_n;
    }
    EXPECT_NEAR(sum_n, sil::gravity_mps2 * (sil::total_mass_kg(scenario::large_suv()) + 300.0), 1.0);
    EXPECT_EQ(vehicle.truth().mass_kg, sil::total_mass_kg(loaded));
}

TEST(Load, RefusesToTakeAwayMoreThanThereIs) {
    EXPECT_THROW(sil::with_load(scenario::large_suv(), -3000.0, 1.0), std::invalid_argument);
    EXPECT_THROW(sil::with_load(scenario::large_suv(), -1500.0, 2.5), std::invalid_argument);
    EXPECT_THROW(sil::with_friction(scenario::large_suv(), 0.0), std::invalid_argument);
    EXPECT_THROW(sil::with_friction(scenario::large_suv(), std::nan("")), std::invalid_argument);
}

TEST(Friction, ScalesWhatASlidingVehicleReaches) {
    const auto circle = scenario::manoeuvre(50.0, 8.0, [](double time_s) {
        return sil::DriverCommand{sil::ramp_and_hold(time_s, 1.0, 3.0, sil::from_degrees(500.0)),
                                  sil::SpeedPolicy::held};
    });
    const sil::VehicleParameters dry = scenario::ordinary_suv();
    const double on_dry = scenario::drive(dry, circle).final_ay_g;
    const double on_wet = scenario::drive(sil::with_friction(dry, 0.5), circle).final_ay_g;
    EXPECT_NEAR(on_wet / on_dry, 0.5, 0.05);
}

TEST(RunOptions, SpeedAndSteeringFactorsScaleWhatTheDriverDoes) {
    const auto turn = scenario::manoeuvre(60.0, 3.0, [](double time_s) {
        return sil::DriverCommand{sil::ramp_and_hold(time_s, 0.5, 1.0, 0.5), sil::SpeedPolicy::held};
    });
    for (const bool mirrored : {false, true}) {
        sil::RunOptions options;
        options.mirrored = mirrored;
        options.speed_factor = 1.2;
        options.steering_factor = 0.8;
        sil::ManoeuvreRun run{scenario::ordinary_suv(), turn, options};
        EXPECT_NEAR(run.truth().speed_mps, 20.0, 1e-9);
        while (!run.finished()) {
            run.step();
        }
        EXPECT_NEAR(run.truth().speed_mps, 20.0, 0.2);
        EXPECT_NEAR(run.truth().steering_wheel_angle_rad, mirrored ? -0.4 : 0.4, 1e-12);
    }
}

}  // namespace
