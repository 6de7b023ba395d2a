// J-turn at 110 km/h: rollover (the paper's Figs 9 and 10). The driver lifts the foot as he begins to steer.
#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {
namespace {

constexpr double start_s = 1.0;

std::unique_ptr<Driver> driver(const VehicleParameters& parameters, double rate_radps) {
    return open_loop([rate_radps](double time_s) {
        return DriverCommand{ramp_and_hold(time_s, start_s, rate_radps, from_degrees(360.0)),
                             time_s < start_s ? SpeedPolicy::held : SpeedPolicy::off_throttle};
    })(parameters);
}

}  // namespace

Manoeuvre j_turn_110() {
    Manoeuvre manoeuvre;
    manoeuvre.name = "j-turn-110";
    manoeuvre.description =
        "J-turn at 110 km/h, throttle released, 360 degrees at the handwheel on a level road";
    manoeuvre.duration_s = 6.0;
    manoeuvre.initial_speed_mps = from_kmh(110.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver_at_rate = driver;
    manoeuvre.make_driver = at_rate(driver, from_degrees(250.0));
    return manoeuvre;
}

}  // namespace sil
