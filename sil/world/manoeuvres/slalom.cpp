// Slalom within the limits of the vehicle: firm but ordinary driving, above 0.4 g to either side.
#include <algorithm>
#include <cmath>

#include "sil/units.hpp"
#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {
namespace {

constexpr double frequency_hz = 0.3;
constexpr double amplitude_rad = from_degrees(42.0);
constexpr double start_s = 1.0;
constexpr double build_up_s = 5.0;  // so that the first swing does not overshoot

double steering_wheel_angle_rad(double time_s) {
    const double since_s = std::max(0.0, time_s - start_s);
    return amplitude_rad * std::min(1.0, since_s / build_up_s) * std::sin(2.0 * pi * frequency_hz * since_s);
}

}  // namespace

Manoeuvre slalom() {
    Manoeuvre manoeuvre;
    manoeuvre.name = "slalom";
    manoeuvre.description =
        "slalom at 80 km/h, held, above 0.4 g to either side on a level road: within the limits";
    manoeuvre.duration_s = 60.0;
    manoeuvre.initial_speed_mps = from_kmh(80.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = open_loop(
        [](double time_s) { return DriverCommand{steering_wheel_angle_rad(time_s), SpeedPolicy::held}; });
    return manoeuvre;
}

}  // namespace sil
