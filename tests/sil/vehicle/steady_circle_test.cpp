// Steady circle: at low lateral acceleration the vehicle follows the handling equation
// delta = L / R + K_us a_y, with K_us = (m_f / C_f - m_r / C_r) from axle loads and cornering stiffnesses.
#include <gtest/gtest.h>
#include <cmath>
#include <string>

#include "scenario.hpp"
#include "sil/world/vehicle/tyre.hpp"

namespace {

double axle_cornering_stiffness(const sil::VehicleParameters& parameters, double axle_weight_n) {
    const double relative = 0.5 * axle_weight_n / parameters.tyre.cornering_stiffness_load_n;
    return 2.0 * parameters.tyre.cornering_stiffness_nprad * std::sin(2.0 * std::atan(relative));
}

sil::Truth steady_turn(const sil::VehicleParameters& parameters, double speed_kmh, double handwheel_deg) {
    sil::ManoeuvreRun run{parameters, scenario::manoeuvre(speed_kmh, 15.0, [handwheel_deg](double time_s) {
                              return sil::DriverCommand{sil::ramp_and_hold(
                                  time_s, 1.0, sil::from_degrees(20.0), sil::from_degrees(handwheel_deg))};
                          })};
    while (!run.finished()) {
        run.step();
    }
    return run.truth();
}

struct Turn {
    double speed_kmh;
    double handwheel_deg;
};

class SteadyCircle : public testing::TestWithParam<Turn> {};

TEST_P(SteadyCircle, NeedsTheSteeringAngleOfTheHandlingEquation) {
    for (sil::VehicleParameters parameters : {scenario::large_suv(), scenario::ordinary_suv()}) {
        parameters = scenario::symmetric(parameters);
        parameters.tyre.camber_thrust_prad = 0.0;  // this and what follows is not part of the equation
        parameters.tyre.rolling_resistance = 0.0;
        parameters.aerodynamics.drag_area_m2 = 0.0;
        parameters.driveline.differential_damping_nmsprad = 0.0;
        const double wheelbase =
            parameters.geometry.front_axle_to_cg_m + parameters.geometry.rear_axle_to_cg_m;
        const double front_weight = scenario::front_axle_weight_n(parameters);
        const double rear_weight = scenario::rear_axle_weight_n(parameters);
        const double understeer = (front_weight / axle_cornering_stiffness(parameters, front_weight) -
                                   rear_weight / axle_cornering_stiffness(parameters, rear_weight)) /
                                  sil::gravity_mps2;

        const sil::Truth truth = steady_turn(parameters, GetParam().speed_kmh, GetParam().handwheel_deg);
        const double a_y = truth.lateral_acceleration_mps2;
        const double curvature = truth.angular_velocity_radps[2] / truth.speed_mps;
        ASSERT_GT(a_y, 0.01 * sil::gravity_mps2);
        ASSERT_LT(a_y, 0.11 * sil::gravity_mps2);
        EXPECT_NEAR(truth.road_wheel_angle_rad, wheelbase * curvature + understeer * a_y,
                    0.005 * truth.road_wheel_angle_rad);
    }
}

INSTANTIATE_TEST_SUITE_P(Turns, SteadyCircle,
                         testing::Values(Turn{36.0, 10.0}, Turn{72.0, 4.0}, Turn{100.0, 3.0}),
                         [](const auto& test) {
                             return "At" + std::to_string(static_cast<int>(test.param.speed_kmh)) +
                                    "KilometresPerHour";
                         });

TEST(SteadyTurn, LateralAccelerationIsSpeedTimesYawRate) {
    const sil::Truth truth = steady_turn(scenario::large_suv(), 60.0, 40.0);
    EXPECT_GT(truth.lateral_acceleration_mps2, 1.5);
    EXPECT_NEAR(truth.lateral_acceleration_mps2, truth.speed_mps * truth.angular_velocity_radps[2], 0.02);
}

TEST(SteadyTurn, ATurnToTheLeftHasPositiveYawRateLateralAccelerationAndRollAndLoadsTheRightWheels) {
    const sil::Truth truth = steady_turn(scenario::large_suv(), 60.0, 40.0);
    EXPECT_GT(truth.angular_velocity_radps[2], 0.0);
    EXPECT_GT(truth.lateral_acceleration_mps2, 0.0);
    EXPECT_GT(truth.roll_angle_rad, 0.0);
    EXPECT_GT(truth.wheel_load_n[sil::front_right], truth.wheel_load_n[sil::front_left]);
    EXPECT_GT(truth.wheel_load_n[sil::rear_right], truth.wheel_load_n[sil::rear_left]);
    EXPECT_GT(truth.suspension_deflection_m[sil::front_right], 0.0);
    EXPECT_LT(truth.suspension_deflection_m[sil::front_left], 0.0);
    EXPECT_GT(truth.lateral_tyre_force_n, 0.0);
}

TEST(SteadyTurn, LateralLoadTransferBalancesTheOverturningMoment) {
    const sil::VehicleParameters parameters = scenario::large_suv();
    const sil::Truth truth = steady_turn(parameters, 60.0, 40.0);
    const auto& load = truth.wheel_load_n;
    const double transfer =
        load[sil::front_right] + load[sil::rear_right] - load[sil::front_left] - load[sil::rear_left];
    // Centre of the whole vehicle: over the road, and moved out as the body rolls about its roll centre.
    const double weight = sil::total_mass_kg(parameters) * sil::gravity_mps2;
    const double moved = parameters.mass.sprung_kg * sil::gravity_mps2 *
                         (parameters.geometry.cg_height_m - truth.roll_centre_height_m) *
                         std::tan(truth.roll_angle_rad);
    const double moment = weight * truth.lateral_acceleration_mps2 / sil::gravity_mps2 *
                              scenario::total_cg_height_m(parameters) +
                          moved;
    EXPECT_NEAR(0.5 * transfer * parameters.geometry.track_width_m, moment, 0.03 * moment);
}

TEST(SteadyTurn, TyresThatGiveWayAddTheWeightTimesTheirDeflectionToTheOverturningMoment) {
    const auto transfer_n = [](const sil::Truth& truth) {
        const auto& load = truth.wheel_load_n;
        return load[sil::front_right] + load[sil::rear_right] - load[sil::front_left] - load[sil::rear_left];
    };
    sil::VehicleParameters parameters = scenario::large_suv();
    const sil::Truth rigid = steady_turn(parameters, 60.0, 40.0);
    const double weight = sil::total_mass_kg(parameters) * sil::gravity_mps2;
    parameters.tyre.lateral_compliance_mpn = 0.020 / (0.25 * weight);
    const sil::Truth soft = steady_turn(parameters, 60.0, 40.0);
    // The lateral forces are about in proportion to the loads.
    double moment_nm = 0.0;
    for (const double load_n : soft.wheel_load_n) {
        const double lateral_n = load_n * soft.lateral_acceleration_mps2 / sil::gravity_mps2;
        moment_nm += load_n * parameters.tyre.lateral_compliance_mpn * lateral_n;
    }
    const double of_rigid_n =
        transfer_n(rigid) * soft.lateral_acceleration_mps2 / rigid.lateral_acceleration_mps2;
    const double more_nm = 0.5 * parameters.geometry.track_width_m * (transfer_n(soft) - of_rigid_n);
    EXPECT_NEAR(more_nm, moment_nm, 0.25 * moment_nm);
}

}  // namespace
