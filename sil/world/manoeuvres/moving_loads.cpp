// Moving loads: a half-full tank in a swing to one side and the other, cargo that breaks loose in a turn. The
// firmware knows mass and height of the load, as far as a campaign lets it know any load, and not that it
// moves.
#include <cmath>

#include "sil/units.hpp"
#include "sil/world/manoeuvres/turn.hpp"
#include "sil/world/vehicle/load.hpp"

namespace sil {
namespace {

constexpr double tank_share = 0.25;   // of the sprung mass
constexpr double cargo_share = 0.15;  // likewise
constexpr double cargo_friction = 0.4;

VehicleParameters with_moving_load(VehicleParameters vehicle, double load_share, double moving_share,
                                   double height_factor) {
    const double load_kg = load_share * vehicle.mass.sprung_kg;
    const double height_m = height_factor * vehicle.geometry.cg_height_m;
    vehicle = with_load(std::move(vehicle), load_kg, height_m);
    vehicle.moving_load.mass_kg = moving_share * load_kg;
    vehicle.moving_load.above_cg_m = height_m - vehicle.geometry.cg_height_m;
    return vehicle;
}

// A rectangular tank without baffles, as wide as 0.8 of the track and filled to half its width. 47 % of its
// liquid move in the first mode, at sqrt(pi g tanh(pi d / w) / w) with width w and depth d = w / 2 (Ibrahim,
// Liquid Sloshing Dynamics, 2005).
VehicleParameters with_tank(VehicleParameters vehicle) {
    constexpr double height_factor = 1.2;
    constexpr double moving_share = 0.47;
    constexpr double tanh_of_half_pi = 0.917152;
    const double width_m = 0.8 * vehicle.geometry.track_width_m;
    vehicle = with_moving_load(std::move(vehicle), tank_share, moving_share, height_factor);
    vehicle.moving_load.frequency_radps = std::sqrt(pi * gravity_mps2 * tanh_of_half_pi / width_m);
    vehicle.moving_load.damping_ratio = 0.05;
    vehicle.moving_load.travel_m = 0.25 * width_m;
    return vehicle;
}

// Loose on a floor: held by friction up to 0.4 g, and free to slide by 0.15 of the track.
VehicleParameters with_loose_cargo(VehicleParameters vehicle) {
    constexpr double height_factor = 1.1;
    vehicle = with_moving_load(std::move(vehicle), cargo_share, 1.0, height_factor);
    vehicle.moving_load.friction = cargo_friction;
    vehicle.moving_load.travel_m = 0.15 * vehicle.geometry.track_width_m;
    return vehicle;
}

}  // namespace

Manoeuvre sloshing_load() {
    Manoeuvre manoeuvre = swings(5.0);
    manoeuvre.name = "sloshing-load";
    manoeuvre.description =
        "swings of about 0.5 g at 50 mph, one and a half at 0.4 Hz, with a half-full tank of a quarter of "
        "the mass";
    manoeuvre.duration_s = 8.0;
    manoeuvre.adapt_vehicle = with_tank;
    manoeuvre.is_disturbed = true;
    return manoeuvre;
}

Manoeuvre sliding_load() {
    constexpr double start_s = 2.0;
    Manoeuvre manoeuvre = held_turn(5.0, start_s, 3.0);
    manoeuvre.name = "sliding-load";
    manoeuvre.description =
        "turn of about 0.5 g at 50 mph, held, with cargo of 15 % of the mass that slides from 0.4 g on";
    manoeuvre.duration_s = 7.0;
    manoeuvre.adapt_vehicle = with_loose_cargo;
    manoeuvre.is_disturbed = true;
    return manoeuvre;
}

}  // namespace sil
