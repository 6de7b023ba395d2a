// Scenario: what the vehicle tests share, so that each of them reads as a story.
#pragma once

#include <functional>

#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/road.hpp"
#include "sil/world/vehicle/vehicle.hpp"

namespace scenario {

constexpr double not_yet = -1.0;

sil::VehicleParameters large_suv();
sil::VehicleParameters ordinary_suv();
sil::VehicleParameters van();

// The same vehicle without what tells left from right: the Panhard rod's path is straight up and down.
sil::VehicleParameters symmetric(sil::VehicleParameters parameters);

// The same vehicle without damping in suspensions and tyres.
sil::VehicleParameters undamped(sil::VehicleParameters parameters);

sil::Manoeuvre manoeuvre(double speed_kmh, double duration_s,
                         std::function<sil::DriverCommand(double)> command);

// Height of the centre of gravity of the whole vehicle in static equilibrium.
double total_cg_height_m(const sil::VehicleParameters& parameters);

double front_axle_weight_n(const sil::VehicleParameters& parameters);
double rear_axle_weight_n(const sil::VehicleParameters& parameters);

// Share of the weight that has gone from the one side to the other, 0 to 1.
double load_transfer(const sil::Truth& truth);

struct Outcome {
    double one_wheel_lift_s{not_yet};
    double two_wheel_lift_s{not_yet};
    double two_wheel_lift_ay_g{0.0};
    double two_wheel_lift_horizon_deg{0.0};  // roll relative to the horizon
    double ssf_crossing_s{not_yet};
    double largest_ay_g{0.0};
    double largest_roll_deg{0.0};
    double largest_load_transfer{0.0};
    double largest_ay_until_lift_g{0.0};
    double rsi_crossing_s{not_yet};
    double rsi_crossing_ay_g{0.0};
    double largest_rsi{0.0};
    double final_ay_g{0.0};
    double final_roll_deg{0.0};
};

// Drives to the end and notes what happened. The RSI is the paper's threshold written as
// a_y* / g = (c_w / 2 - H tan phi_f) / h for a level road, with phi_f from the fixed-roll-centre model (1).
Outcome drive(const sil::VehicleParameters& parameters, const sil::Manoeuvre& manoeuvre,
              sil::RunOptions options = {});

}  // namespace scenario
