// Crowned road: out of the own lane over the crown and quickly back, so that the bank changes its side in the
// middle of each change of lane.
#include "sil/random.hpp"
#include "sil/world/manoeuvres/path_driver.hpp"
#include "sil/world/vehicle/uneven_road.hpp"

namespace sil {

Manoeuvre crowned_road() {
    constexpr double lane_m = 3.5;
    constexpr double least_slope = 0.02;
    constexpr double largest_slope = 0.04;
    constexpr double begin_m = 30.0;
    constexpr double change_m = 30.0;
    constexpr double beside_m = 12.0;
    Manoeuvre manoeuvre;
    manoeuvre.name = "crowned-road";
    manoeuvre.description =
        "at 60 km/h into the other lane and back over a crown from which the road falls by 2 to 4 % to "
        "either side";
    manoeuvre.duration_s = 11.0;
    manoeuvre.initial_speed_mps = from_kmh(60.0);
    manoeuvre.make_road = [](std::uint64_t seed) {
        return std::make_unique<CrownedRoad>(between(scrambled(seed), least_slope, largest_slope),
                                             0.5 * lane_m);
    };
    manoeuvre.asks_for_handwheel_angle = true;
    static const auto driver = path_driving(Course{}
                                                .straight(begin_m)
                                                .change_lane(change_m, lane_m)
                                                .straight(beside_m)
                                                .change_lane(change_m, -lane_m)
                                                .straight(100.0),
                                            0.5, begin_m);
    manoeuvre.make_driver = driver;
    return manoeuvre;
}

}  // namespace sil
