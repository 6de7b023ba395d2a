// Straight ahead at constant speed: nothing may warn.
#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {

Manoeuvre straight() {
    Manoeuvre manoeuvre;
    manoeuvre.name = "straight";
    manoeuvre.description = "straight ahead at 100 km/h on a level road";
    manoeuvre.duration_s = 60.0;
    manoeuvre.initial_speed_mps = from_kmh(100.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = open_loop([](double) { return DriverCommand{}; });
    return manoeuvre;
}

}  // namespace sil
