// Static equilibrium: a vehicle at rest carries its weight where statics says, and stays at rest.
#include <gtest/gtest.h>
#include <cmath>

#include "scenario.hpp"

namespace {

class StaticEquilibrium : public testing::TestWithParam<sil::VehicleParameters (*)()> {};

TEST_P(StaticEquilibrium, WheelLoadsAreTheAxleWeightsHalvedFromTheFirstInstantOn) {
    const sil::VehicleParameters parameters = GetParam()();
    const sil::PlaneRoad road;
    sil::Vehicle vehicle{parameters, road};
    for (int step = 0; step < 3000; ++step) {
        const auto& load = vehicle.truth().wheel_load_n;
        ASSERT_NEAR(load[sil::front_left], 0.5 * scenario::front_axle_weight_n(parameters), 1e-3);
        ASSERT_NEAR(load[sil::front_right], 0.5 * scenario::front_axle_weight_n(parameters), 1e-3);
        ASSERT_NEAR(load[sil::rear_left], 0.5 * scenario::rear_axle_weight_n(parameters), 1e-3);
        ASSERT_NEAR(load[sil::rear_right], 0.5 * scenario::rear_axle_weight_n(parameters), 1e-3);
        vehicle.step({});
    }
}

TEST_P(StaticEquilibrium, AnAccelerometerAtRestReadsGravityUpwardsAndNothingTurns) {
    const sil::PlaneRoad road;
    sil::Vehicle vehicle{GetParam()(), road};
    vehicle.step({});
    const sil::Truth& truth = vehicle.truth();
    EXPECT_NEAR(truth.specific_force_mps2[0], 0.0, 1e-6);
    EXPECT_NEAR(truth.specific_force_mps2[1], 0.0, 1e-6);
    EXPECT_NEAR(truth.specific_force_mps2[2], sil::gravity_mps2, 1e-6);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(truth.angular_velocity_radps[axis], 0.0, 1e-9);
        EXPECT_NEAR(truth.angular_acceleration_radps2[axis], 0.0, 1e-6);
    }
}

TEST_P(StaticEquilibrium, ADisturbedVehicleComesBackToTheSameEquilibrium) {
    const sil::VehicleParameters parameters = GetParam()();
    const sil::PlaneRoad road;
    sil::Vehicle vehicle{parameters, road};
    sil::InitialState disturbed;
    disturbed.height_offset_m = 0.10;
    disturbed.roll_offset_rad = 0.08;
    disturbed.pitch_offset_rad = 0.03;
    vehicle.reset(disturbed);
    for (int step = 0; step < 8000; ++step) {
        vehicle.step({});
    }
    EXPECT_NEAR(vehicle.truth().position_z_m, parameters.geometry.cg_height_m, 2e-4);
    EXPECT_NEAR(vehicle.truth().roll_angle_rad, 0.0, 2e-4);
    EXPECT_NEAR(vehicle.truth().pitch_angle_rad, 0.0, 2e-4);
}

TEST_P(StaticEquilibrium, RollingStraightAtConstantSpeedNeedsTheForceOfDragAndRollingResistance) {
    const sil::VehicleParameters parameters = GetParam()();
    const sil::PlaneRoad road;
    sil::Vehicle vehicle{parameters, road};
    sil::InitialState rolling;
    rolling.speed_mps = 25.0;
    vehicle.reset(rolling);
    sil::DriverInput input;
    input.drive_force_n =
        parameters.tyre.rolling_resistance * sil::total_mass_kg(parameters) * sil::gravity_mps2 +
        0.5 * 1.2 * parameters.aerodynamics.drag_area_m2 * 25.0 * 25.0;
    for (int step = 0; step < 5000; ++step) {
        vehicle.step(input);
    }
    // The drive torque is computed with the unloaded radius, which is some 5 % larger than the loaded one.
    const double largest_speed_gain = 0.07 * input.drive_force_n / sil::total_mass_kg(parameters) * 5.0;
    EXPECT_NEAR(vehicle.truth().speed_mps, 25.0, largest_speed_gain);
}

TEST_P(StaticEquilibrium, AFreelyRollingWheelTurnsAtTheSpeedOverItsLoadedRadius) {
    sil::VehicleParameters parameters = GetParam()();
    parameters.tyre.rolling_resistance = 0.0;
    parameters.aerodynamics.drag_area_m2 = 0.0;
    const sil::PlaneRoad road;
    sil::Vehicle vehicle{parameters, road};
    sil::InitialState rolling;
    rolling.speed_mps = 20.0;
    vehicle.reset(rolling);
    for (int step = 0; step < 3000; ++step) {
        vehicle.step({});
    }
    const double front_radius =
        parameters.geometry.wheel_radius_m -
        0.5 * scenario::front_axle_weight_n(parameters) / parameters.tyre.vertical_stiffness_npm;
    EXPECT_NEAR(vehicle.truth().speed_mps, 20.0, 0.001);
    EXPECT_NEAR(vehicle.truth().wheel_spin_radps[sil::front_left] * front_radius, 20.0, 0.005);
}

INSTANTIATE_TEST_SUITE_P(Vehicles, StaticEquilibrium,
                         testing::Values(&scenario::large_suv, &scenario::ordinary_suv),
                         [](const auto& test) { return test.index == 0 ? "LargeSuv" : "OrdinarySuv"; });

}  // namespace
