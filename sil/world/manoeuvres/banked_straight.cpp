// Banked straight: onto a bank of 6 degrees, along it, and down from it, in one lane.
#include "sil/world/manoeuvres/lane_keeping.hpp"
#include "sil/world/vehicle/uneven_road.hpp"

namespace sil {

Manoeuvre banked_straight() {
    Manoeuvre manoeuvre;
    manoeuvre.name = "banked-straight";
    manoeuvre.description =
        "straight at 80 km/h: level, over 40 m onto a bank of 6 degrees, 300 m along it, level again";
    manoeuvre.duration_s = 25.0;
    manoeuvre.initial_speed_mps = from_kmh(80.0);
    manoeuvre.make_road = [](std::uint64_t) {
        return std::make_unique<BankedStretchRoad>(from_degrees(6.0), 50.0, 390.0, 40.0);
    };
    manoeuvre.make_driver = lane_keeping();
    manoeuvre.asks_for_handwheel_angle = true;
    return manoeuvre;
}

}  // namespace sil
