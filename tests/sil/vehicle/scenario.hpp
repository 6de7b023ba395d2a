// Scenario: what the vehicle tests share, so that each of them reads as a story.
#pragma once

#include <cmath>
#include <functional>

#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/road.hpp"
#include "sil/world/vehicle/vehicle.hpp"

namespace scenario {

constexpr double not_yet = -1.0;
constexpr double degree = 3.14159265358979323846 / 180.0;

sil::VehicleParameters large_suv();
sil::VehicleParameters ordinary_suv();
sil::VehicleParameters van();

// The same vehicle without what tells left from right: the Panhard rod's path is straight up and down.
sil::VehicleParameters symmetric(sil::VehicleParameters parameters);

// The same vehicle without damping in suspensions and tyres.
sil::VehicleParameters undamped(sil::VehicleParameters parameters);

// The same vehicle on a frame of the given torsional stiffness, half of the sprung mass behind it.
sil::VehicleParameters twisting(sil::VehicleParameters parameters, double torsion_nmprad);

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

// A plane that the test turns about the x axis, with a surface that does not let the vehicle slide.
class TiltTable final : public sil::Road {
 public:
    void tilt_to(double angle_rad) { angle_rad_ = angle_rad; }
    sil::RoadPoint at(double /*x_m*/, double y_m) const noexcept override {
        sil::RoadPoint point;
        point.height_m = std::tan(angle_rad_) * y_m;
        point.normal = {0.0, -std::sin(angle_rad_), std::cos(angle_rad_)};
        point.friction_factor = 4.0;
        return point;
    }

 private:
    double angle_rad_{0.0};
};

// Drives to the end and notes what happened. The RSI is the paper's threshold written as
// a_y* / g = (c_w / 2 - H tan phi_f) / h for a level road, with phi_f from the fixed-roll-centre model (1).
Outcome drive(const sil::VehicleParameters& parameters, const sil::Manoeuvre& manoeuvre,
              sil::RunOptions options = {});

}  // namespace scenario
