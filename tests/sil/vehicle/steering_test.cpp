// Steering: the road wheels follow with a lag and give way to the tyres' force, where the vehicle's file says
// so.
#include <gtest/gtest.h>
#include <cmath>

#include "scenario.hpp"

namespace {

constexpr double handwheel_rad = 0.2;

sil::ManoeuvreRun turning(const sil::VehicleParameters& parameters, double duration_s) {
    return {parameters,
            scenario::manoeuvre(60.0, duration_s, [](double) { return sil::DriverCommand{handwheel_rad}; })};
}

TEST(Steering, WithALagTheWheelsCoverTwoThirdsOfAStepInIt) {
    sil::VehicleParameters parameters = scenario::large_suv();
    for (const double lag_s : {0.0, 0.02, 0.1}) {
        parameters.steering.lag_s = lag_s;
        sil::ManoeuvreRun run = turning(parameters, 1.0);
        while (run.truth().time_s < (lag_s > 0.0 ? lag_s : 0.001) - 1e-9) {
            run.step();
        }
        EXPECT_EQ(run.truth().steering_wheel_angle_rad, handwheel_rad)
            << "what the sensor at the handwheel sees";
        const double share = lag_s > 0.0 ? 1.0 - std::exp(-1.0) : 1.0;
        EXPECT_NEAR(run.truth().road_wheel_angle_rad, share * handwheel_rad / parameters.steering.ratio,
                    lag_s > 0.0 ? 2e-4 : 0.0)
            << lag_s;
    }
}

TEST(Steering, ThatGivesWayTurnsTheWheelsBackByTheFrontAxlesForce) {
    sil::VehicleParameters parameters = scenario::symmetric(scenario::large_suv());
    parameters.steering.compliance_radpn = 2.0e-6;
    sil::ManoeuvreRun run = turning(parameters, 12.0);
    while (!run.finished()) {
        run.step();
    }
    const sil::Truth& truth = run.truth();
    const double front_n =
        scenario::front_axle_weight_n(parameters) / sil::gravity_mps2 * truth.lateral_acceleration_mps2;
    ASSERT_GT(truth.lateral_acceleration_mps2, 0.5);
    EXPECT_NEAR(handwheel_rad / parameters.steering.ratio - truth.road_wheel_angle_rad, 2.0e-6 * front_n,
                0.03 * 2.0e-6 * front_n);
}

TEST(Steering, ThatGivesWayIsTheSameToBothSides) {
    sil::VehicleParameters parameters = scenario::symmetric(scenario::large_suv());
    parameters.steering.compliance_radpn = 2.0e-6;
    parameters.steering.lag_s = 0.05;
    sil::RunOptions mirrored;
    mirrored.mirrored = true;
    const sil::Manoeuvre manoeuvre =
        scenario::manoeuvre(60.0, 3.0, [](double) { return sil::DriverCommand{handwheel_rad}; });
    sil::ManoeuvreRun left{parameters, manoeuvre};
    sil::ManoeuvreRun right{parameters, manoeuvre, mirrored};
    while (!left.finished()) {
        left.step();
        right.step();
        ASSERT_NEAR(left.truth().road_wheel_angle_rad, -right.truth().road_wheel_angle_rad, 1e-9);
    }
}

}  // namespace
