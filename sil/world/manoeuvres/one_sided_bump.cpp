// One-sided bumps: the left wheels climb over, the right ones do not.
#include "sil/world/manoeuvres/lane_keeping.hpp"
#include "sil/world/vehicle/uneven_road.hpp"

namespace sil {

Manoeuvre one_sided_bump() {
    Manoeuvre manoeuvre;
    manoeuvre.name = "one-sided-bump";
    manoeuvre.description =
        "straight at 40 km/h over three bumps under the left wheels, 50 mm high and 3 m long";
    manoeuvre.duration_s = 12.0;
    manoeuvre.initial_speed_mps = from_kmh(40.0);
    manoeuvre.make_road = [](std::uint64_t) {
        return std::make_unique<OneSidedBumpRoad>(0.05, 3.0, 20.0, 25.0, 3);
    };
    manoeuvre.make_driver = lane_keeping();
    manoeuvre.asks_for_handwheel_angle = true;
    return manoeuvre;
}

}  // namespace sil
