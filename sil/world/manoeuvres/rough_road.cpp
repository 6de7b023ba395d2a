// Rough road, straight: left and right wheels shake on their own, and nothing may warn.
#include "sil/world/manoeuvres/lane_keeping.hpp"
#include "sil/world/vehicle/uneven_road.hpp"

namespace sil {

Manoeuvre rough_road() {
    Manoeuvre manoeuvre;
    manoeuvre.name = "rough-road";
    manoeuvre.description =
        "straight at 80 km/h on a rough road (ISO 8608 class C, left and right tracks independent)";
    manoeuvre.duration_s = 30.0;
    manoeuvre.initial_speed_mps = from_kmh(80.0);
    manoeuvre.make_road = [](std::uint64_t seed) {
        return std::make_unique<TwoTrackRoad>(RoughnessProfile::class_c_m3, seed);
    };
    manoeuvre.make_driver = lane_keeping();
    manoeuvre.asks_for_handwheel_angle = true;
    return manoeuvre;
}

}  // namespace sil
