// Trailer: swings to one side and the other with a heavy trailer, which swings after and pulls the tail
// along.
#include "sil/world/manoeuvres/turn.hpp"

namespace sil {
namespace {

constexpr double mass_share = 0.6;

// A centre-axle trailer of the vehicle's size.
VehicleParameters with_trailer(VehicleParameters vehicle) {
    const double length_m = wheelbase_m(vehicle.geometry);
    TrailerParameters& trailer = vehicle.trailer;
    trailer.mass_kg = mass_share * total_mass_kg(vehicle);
    trailer.drawbar_m = length_m;
    trailer.axle_behind_cg_m = 0.05 * length_m;
    trailer.yaw_inertia_kgm2 = trailer.mass_kg * 0.16 * length_m * length_m;
    trailer.hitch_behind_cg_m = vehicle.geometry.rear_axle_to_cg_m + 0.35 * length_m;
    trailer.hitch_height_m = 1.2 * vehicle.geometry.wheel_radius_m;
    return vehicle;
}

}  // namespace

Manoeuvre trailer() {
    Manoeuvre manoeuvre = swings(5.0);
    manoeuvre.name = "trailer";
    manoeuvre.description =
        "swings of about 0.5 g at 50 mph, one and a half at 0.4 Hz, with a trailer of 0.6 times the mass";
    manoeuvre.duration_s = 9.0;
    manoeuvre.adapt_vehicle = with_trailer;
    manoeuvre.is_disturbed = true;
    return manoeuvre;
}

}  // namespace sil
