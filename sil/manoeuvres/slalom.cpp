// Slalom within the limits of the vehicle: firm but ordinary driving, about 0.4 g to either side.
#include <cmath>

#include "sil/manoeuvres/manoeuvre.hpp"

namespace sil {
namespace {

constexpr double frequency_hz = 0.3;
constexpr double amplitude_rad = from_degrees(75.0);
constexpr double start_s = 1.0;
constexpr double pi = 3.14159265358979323846;

}  // namespace

Manoeuvre slalom() {
    Manoeuvre manoeuvre;
    manoeuvre.name = "slalom";
    manoeuvre.description = "slalom at 80 km/h, held, about 0.4 g to either side: within the limits";
    manoeuvre.duration_s = 60.0;
    manoeuvre.initial_speed_mps = from_kmh(80.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = open_loop([](double time_s) {
        const double since = time_s > start_s ? time_s - start_s : 0.0;
        return DriverCommand{amplitude_rad * std::sin(2.0 * pi * frequency_hz * since), SpeedPolicy::held};
    });
    return manoeuvre;
}

}  // namespace sil
