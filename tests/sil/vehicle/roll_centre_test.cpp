// Roll centres: equation (24) and the kinematic one against the suspensions' geometry.
#include <gtest/gtest.h>
#include <cmath>

#include "scenario.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"

namespace {

sil::Truth gentle_turn(const sil::VehicleParameters& parameters, double handwheel_deg) {
    sil::ManoeuvreRun run{parameters, scenario::manoeuvre(60.0, 10.0, [handwheel_deg](double time_s) {
                              return sil::DriverCommand{sil::ramp_and_hold(
                                  time_s, 1.0, sil::from_degrees(60.0), sil::from_degrees(handwheel_deg))};
                          })};
    while (!run.finished()) {
        run.step();
    }
    return run.truth();
}

TEST(ForceBasedRollCentre, IsTheForceWeightedMeanOfTheAxlesRollCentres) {
    sil::VehicleParameters parameters = scenario::symmetric(scenario::large_suv());
    parameters.front_suspension.path_slope_1_pm =
        0.0;  // a straight path: the height is slope times half track
    parameters.front_suspension.path_slope_2_pm2 = 0.0;
    parameters.front_suspension.anti_roll_bar_npm = 400.0e3;  // hardly any roll: the geometry stays as it is
    parameters.rear_suspension.anti_roll_bar_nmprad = 500.0e3;
    const sil::Truth truth = gentle_turn(parameters, 60.0);

    const double a_y = truth.lateral_acceleration_mps2;
    const double front_force = scenario::front_axle_weight_n(parameters) / sil::gravity_mps2 * a_y;
    const double rear_force = scenario::rear_axle_weight_n(parameters) / sil::gravity_mps2 * a_y;
    const double wheel_height = parameters.geometry.wheel_radius_m - 0.02;  // loaded
    // The links carry the axle's force less that of its own unsprung mass; that mass's share of
    // (24) is its moment about the road (front: its slope, like the tyre's force).
    const double front_moment = (front_force - 2.0 * parameters.mass.front_unsprung_kg * a_y) *
                                parameters.front_suspension.path_slope_0 * 0.5 *
                                parameters.geometry.track_width_m;
    const double rear_moment = (rear_force - parameters.mass.rear_axle_kg * a_y) *
                                   (wheel_height + parameters.rear_suspension.panhard_pivot_m) +
                               parameters.mass.rear_axle_kg * a_y * wheel_height;
    EXPECT_GT(truth.lateral_tyre_force_n, 6000.0);
    EXPECT_NEAR(truth.roll_centre_height_m, (front_moment + rear_moment) / (front_force + rear_force), 0.01);
}

TEST(ForceBasedRollCentre, IsNotANumberWhileTheLateralForceIsSmallOrAWheelIsOff) {
    EXPECT_TRUE(std::isnan(gentle_turn(scenario::large_suv(), 10.0).roll_centre_height_m));
    sil::ManoeuvreRun run{scenario::large_suv(), sil::find_manoeuvre("j-turn-110")};
    bool seen = false;
    while (!run.finished()) {
        run.step();
        const sil::Truth& truth = run.truth();
        for (const double load_n : truth.wheel_load_n) {
            if (load_n <= 0.0) {
                seen = true;
                ASSERT_TRUE(std::isnan(truth.roll_centre_height_m));
            }
        }
    }
    EXPECT_TRUE(seen);
}

TEST(KinematicRollCentre, StandsStillSidewaysWhenThePathSlopeGrowsByTwoOverTheTrack) {
    sil::VehicleParameters parameters = scenario::large_suv();
    parameters.front_suspension.path_slope_1_pm = 2.0 / parameters.geometry.track_width_m;
    parameters.front_suspension.path_slope_2_pm2 = 0.0;
    parameters.tyre.vertical_stiffness_npm = 3.0e6;  // roll of the tyres would add to that of the suspension
    parameters.tyre.vertical_damping_nspm = 3.0e3;
    const sil::Truth fixed = gentle_turn(parameters, 40.0);
    EXPECT_NEAR(fixed.roll_centre_lateral_m, 0.0, 0.06);
    EXPECT_NEAR(fixed.roll_centre_kinematic_height_m,
                parameters.front_suspension.path_slope_0 * 0.5 * parameters.geometry.track_width_m, 0.02);
}

TEST(KinematicRollCentre, MovesTowardsTheInnerWheelByNearlyHalfAMetreInTheJTurn) {
    sil::ManoeuvreRun run{scenario::large_suv(), sil::find_manoeuvre("j-turn-45")};
    double largest = 0.0;
    double lowest_height = 1.0;
    while (!run.finished()) {
        run.step();
        if (!std::isnan(run.truth().roll_centre_lateral_m)) {
            largest = std::max(largest, -run.truth().roll_centre_lateral_m);
            lowest_height = std::min(lowest_height, run.truth().roll_centre_kinematic_height_m);
        }
    }
    // The paper's Fig. 1 and Fig. 6: about 480 mm sideways and 65 mm up or down.
    EXPECT_NEAR(largest, 0.480, 0.03);
    EXPECT_NEAR(run.truth().roll_centre_lateral_m, -0.46, 0.03);
    EXPECT_GT(0.12 - lowest_height, 0.02);
    EXPECT_LT(0.12 - lowest_height, 0.07);
}

}  // namespace
