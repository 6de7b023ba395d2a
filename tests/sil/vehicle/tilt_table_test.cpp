// Tilt table: the angle at which the uphill wheels lift, against statics.
#include <gtest/gtest.h>
#include <cmath>

#include "scenario.hpp"
#include "tests/support/nominal_roll_model.hpp"

namespace {

using scenario::degree;

struct Tipping {
    double angle_rad{0.0};
    double roll_rad{0.0};  // of the body relative to the table
    sil::Truth truth{};
};

// Tilts at one degree a second, left side up, until both left wheels are off.
Tipping tilt_until_two_wheels_lift(const sil::VehicleParameters& parameters) {
    scenario::TiltTable table;
    sil::Vehicle vehicle{parameters, table};
    for (int step = 0; step < 60000; ++step) {
        const double angle_rad = step * 0.001 * degree;
        table.tilt_to(angle_rad);
        vehicle.step({});
        const sil::Truth& truth = vehicle.truth();
        if (left_side_has_lifted(truth)) {
            return {angle_rad, truth.roll_angle_rad, truth};
        }
    }
    return {};
}

sil::VehicleParameters rigid(sil::VehicleParameters parameters) {
    for (sil::SpringDamperParameters* unit :
         {&parameters.front_suspension.spring_damper, &parameters.rear_suspension.spring_damper}) {
        unit->spring_npm = 3.0e6;
        unit->jounce_stop_npm2 = 0.0;
        unit->rebound_stop_npm2 = 0.0;
        unit->damper_bump_nspm = 10.0e3;
        unit->damper_rebound_nspm = 10.0e3;
    }
    parameters.tyre.vertical_stiffness_npm = 4.0e6;
    parameters.tyre.vertical_damping_nspm = 3.0e3;
    return parameters;
}

TEST(TiltTable, ARigidVehicleTipsAtTheAngleOfHalfTrackOverHeight) {
    for (const sil::VehicleParameters& parameters :
         {rigid(scenario::large_suv()), rigid(scenario::ordinary_suv())}) {
        const Tipping tipping = tilt_until_two_wheels_lift(parameters);
        const double closed_form =
            std::atan(0.5 * parameters.geometry.track_width_m / scenario::total_cg_height_m(parameters));
        EXPECT_NEAR(tipping.angle_rad / degree, closed_form / degree, 0.3);
    }
}

TEST(TiltTable, ASprungVehicleTipsEarlierByWhatItsRollTakesFromTheLever) {
    for (const sil::VehicleParameters& parameters : {scenario::large_suv(), scenario::ordinary_suv()}) {
        const Tipping tipping = tilt_until_two_wheels_lift(parameters);
        // Moments about the downhill contacts, with the body's CG moved out and up or down as measured.
        const sil::Truth& truth = tipping.truth;
        const double table = tipping.angle_rad;
        const double height =
            truth.position_z_m * std::cos(table) - truth.position_y_m * std::sin(table);  // over the table
        const double h_frc = rsi_test::nominal_roll_model(parameters.name).roll_centre_height_m;
        const double moved = (parameters.geometry.cg_height_m - h_frc) * std::tan(tipping.roll_rad);
        const double half_track = 0.5 * parameters.geometry.track_width_m;
        const double unsprung = sil::total_mass_kg(parameters) - parameters.mass.sprung_kg;
        const double closed_form =
            std::atan((parameters.mass.sprung_kg * (half_track - moved) + unsprung * half_track) /
                      (parameters.mass.sprung_kg * height + unsprung * parameters.geometry.wheel_radius_m));
        const double rigid_form = std::atan(half_track / scenario::total_cg_height_m(parameters));
        EXPECT_GT(tipping.roll_rad, 0.0);
        EXPECT_LT(tipping.angle_rad, rigid_form - 1.0 * degree);
        EXPECT_NEAR(tipping.angle_rad / degree, closed_form / degree, 0.7);
    }
}

}  // namespace
