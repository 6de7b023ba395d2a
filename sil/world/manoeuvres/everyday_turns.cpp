#include "sil/world/manoeuvres/everyday_turns.hpp"

#include <algorithm>
#include <cmath>

#include "sil/units.hpp"
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"

namespace sil {
namespace {

constexpr double ramp_s = 1.0;
constexpr double held_s = 4.0;

// Share of the turn's handwheel angle, with its sign.
double share_of_turn(double time_s) {
    const double number = std::floor(time_s / gentle_turn_s);
    const double since_s = time_s - number * gentle_turn_s;
    const double share = std::clamp(std::min(since_s, 2.0 * ramp_s + held_s - since_s) / ramp_s, 0.0, 1.0);
    return std::fmod(number, 2.0) < 0.5 ? share : -share;
}

}  // namespace

Manoeuvre gentle_turns(double duration_s) {
    constexpr double share_of_0_3_g = 2.0 / 3.0;
    Manoeuvre manoeuvre;
    manoeuvre.name = "gentle-turns";
    manoeuvre.duration_s = duration_s;
    manoeuvre.initial_speed_mps = from_mph(50.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.asks_for_handwheel_angle = true;
    manoeuvre.make_driver = [](const VehicleParameters& parameters) {
        const double angle_rad = share_of_0_3_g * handwheel_angle_at_0_3_g_rad(parameters);
        return open_loop([angle_rad](double time_s) {
            return DriverCommand{angle_rad * share_of_turn(time_s)};
        })(parameters);
    };
    return manoeuvre;
}

Manoeuvre slow_turns(double duration_s) {
    constexpr double period_s = 8.0;
    Manoeuvre manoeuvre;
    manoeuvre.name = "slow-turns";
    manoeuvre.duration_s = duration_s;
    manoeuvre.initial_speed_mps = from_kmh(12.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = open_loop([](double time_s) {
        return DriverCommand{from_degrees(300.0) * std::sin(2.0 * pi / period_s * time_s)};
    });
    return manoeuvre;
}

}  // namespace sil
