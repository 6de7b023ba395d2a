// J-turn at 45 km/h: no rollover (the paper's Figs 5 to 8).
#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {
namespace {

std::unique_ptr<Driver> driver(const VehicleParameters& parameters, double rate_radps) {
    return open_loop([rate_radps](double time_s) {
        return DriverCommand{ramp_and_hold(time_s, 1.0, rate_radps, from_degrees(360.0)), SpeedPolicy::held};
    })(parameters);
}

}  // namespace

Manoeuvre j_turn_45() {
    Manoeuvre manoeuvre;
    manoeuvre.name = "j-turn-45";
    manoeuvre.description = "J-turn at 45 km/h, held, 360 degrees at the handwheel on a level road: stays up";
    manoeuvre.duration_s = 10.0;
    manoeuvre.initial_speed_mps = from_kmh(45.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver_at_rate = driver;
    manoeuvre.make_driver = at_rate(driver, from_degrees(250.0));
    return manoeuvre;
}

}  // namespace sil
