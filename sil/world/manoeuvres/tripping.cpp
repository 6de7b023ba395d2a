// Tripping: a vehicle that has lost its grip slides sideways on a slick road, against a kerb or off into soft
// ground.
#include "sil/random.hpp"
#include "sil/world/manoeuvres/manoeuvre.hpp"
#include "sil/world/vehicle/trip_road.hpp"

namespace sil {
namespace {

// At 60 km/h, with 24 km/h to the left at the beginning.
Manoeuvre sliding() {
    Manoeuvre manoeuvre;
    manoeuvre.duration_s = 6.0;
    manoeuvre.initial_speed_mps = from_kmh(60.0);
    manoeuvre.start_sideways_share = 0.4;
    manoeuvre.make_driver = open_loop([](double) { return DriverCommand{0.0, SpeedPolicy::off_throttle}; });
    manoeuvre.is_disturbed = true;
    return manoeuvre;
}

constexpr double slick = 0.15;  // of the friction
constexpr double half_vehicle_m = 1.0;

}  // namespace

Manoeuvre kerb_trip() {
    Manoeuvre manoeuvre = sliding();
    manoeuvre.name = "kerb-trip";
    manoeuvre.description =
        "slides at 60 km/h, and 24 km/h sideways, on a slick road against a kerb of 100 to 200 mm";
    manoeuvre.make_road = [](std::uint64_t seed) {
        return std::make_unique<KerbRoad>(half_vehicle_m + 4.0, between(scrambled(seed), 0.10, 0.20), slick);
    };
    return manoeuvre;
}

Manoeuvre soil_trip() {
    Manoeuvre manoeuvre = sliding();
    manoeuvre.name = "soil-trip";
    manoeuvre.description =
        "slides at 60 km/h, and 24 km/h sideways, off a slick road into soft ground that piles up beside the "
        "wheels";
    manoeuvre.make_road = [](std::uint64_t seed) {
        return std::make_unique<SoftShoulderRoad>(half_vehicle_m + 3.0, between(scrambled(seed), 0.5, 1.5),
                                                  slick, 0.6);
    };
    return manoeuvre;
}

}  // namespace sil
