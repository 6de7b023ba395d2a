// Fixed against moving roll centre (the paper's Fig. 2): one input, two vehicles.
#include "sil/world/manoeuvres/roll_centre_comparison.hpp"

#include <utility>

#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {
namespace {

constexpr double start_s = 1.0;
constexpr double straight_rod_m = 1.0e6;  // so long that its end moves straight up and down

DriverCommand command(double time_s) {
    return {ramp_and_hold(time_s, start_s, from_degrees(250.0), from_degrees(180.0)),
            time_s < start_s ? SpeedPolicy::held : SpeedPolicy::off_throttle};
}

void make_linear_and_symmetric(SpringDamperParameters& unit) {
    unit.jounce_stop_npm2 = 0.0;
    unit.rebound_stop_npm2 = 0.0;
    const double damper = 0.5 * (unit.damper_bump_nspm + unit.damper_rebound_nspm);
    unit.damper_bump_nspm = damper;
    unit.damper_rebound_nspm = damper;
}

Manoeuvre comparison() {
    Manoeuvre manoeuvre;
    manoeuvre.duration_s = 8.0;
    manoeuvre.initial_speed_mps = from_kmh(68.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = open_loop(command);
    return manoeuvre;
}

}  // namespace

// The paper's words for this vehicle: symmetric and linear suspension properties, assuming a fixed roll
// centre. A front roll centre fixed in the body has Y'(q) = slope_0 - (2 / c_w) q.
VehicleParameters with_fixed_roll_centre(VehicleParameters parameters) {
    parameters.front_suspension.path_slope_1_pm = 2.0 / parameters.geometry.track_width_m;
    parameters.front_suspension.path_slope_2_pm2 = 0.0;
    parameters.rear_suspension.panhard_slope = 0.0;
    parameters.rear_suspension.panhard_length_m = straight_rod_m;
    return parameters;
}

VehicleParameters with_linear_suspension(VehicleParameters parameters) {
    make_linear_and_symmetric(parameters.front_suspension.spring_damper);
    make_linear_and_symmetric(parameters.rear_suspension.spring_damper);
    return parameters;
}

Manoeuvre roll_centre_moving() {
    Manoeuvre manoeuvre = comparison();
    manoeuvre.name = "roll-centre-moving";
    manoeuvre.description =
        "J-turn at 68 km/h, throttle released, 180 degrees: the vehicle as it is, beside roll-centre-fixed";
    return manoeuvre;
}

Manoeuvre roll_centre_fixed() {
    Manoeuvre manoeuvre = comparison();
    manoeuvre.name = "roll-centre-fixed";
    manoeuvre.description =
        "the same J-turn with a fixed roll centre and linear, symmetric springs and dampers (Fig. 2)";
    manoeuvre.adapt_vehicle = [](VehicleParameters parameters) {
        return with_linear_suspension(with_fixed_roll_centre(std::move(parameters)));
    };
    return manoeuvre;
}

}  // namespace sil
