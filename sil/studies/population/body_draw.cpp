// Body draw: masses, geometry and inertias.
#include "sil/studies/population/vehicle_draft.hpp"

namespace sil {
namespace {

constexpr double rotor_mass_share = 0.35;    // of a wheel's unsprung mass, at its rim
constexpr double axle_gyration_share = 0.9;  // of half the track: the masses are at the ends

}  // namespace

void draw_axles_and_masses(VehicleDraft& draft) {
    VehicleParameters& v = draft.vehicle;
    draft.rigid_front = draft.random.happens(Quantity::rigid_front, draft.from.rigid_front_share);
    draft.rigid_rear = draft.random.happens(Quantity::rigid_rear, draft.from.rigid_rear_share);
    draft.mass_kg = draft.sized(Quantity::mass, &VehicleClass::mass_kg);
    const double unsprung = draft.mass_kg * draft.within(Quantity::unsprung, &VehicleClass::unsprung_share);
    // A rigid axle carries its own beam, and a driven one its gear.
    const double rear_share = draft.rigid_rear && !draft.rigid_front ? 0.58 : 0.52;
    v.mass.front_unsprung_kg = 0.5 * (1.0 - rear_share) * unsprung;
    v.mass.rear_axle_kg = rear_share * unsprung;
    v.mass.sprung_kg = draft.mass_kg - unsprung;
    draft.front_share = draft.within(Quantity::front_load, &VehicleClass::front_load_share);
}

void draw_geometry(VehicleDraft& draft) {
    VehicleParameters& v = draft.vehicle;
    GeometryParameters& g = v.geometry;
    const double wheelbase = draft.sized(Quantity::wheelbase, &VehicleClass::wheelbase_m);
    g.track_width_m = draft.sized(Quantity::track, &VehicleClass::track_width_m);
    g.wheel_radius_m = draft.sized(Quantity::wheel_radius, &VehicleClass::wheel_radius_m);
    g.front_axle_to_cg_m = (1.0 - draft.front_share) * wheelbase;
    g.rear_axle_to_cg_m = draft.front_share * wheelbase;
    const double height =
        0.5 * g.track_width_m /
        draft.within(Quantity::static_stability_factor, &VehicleClass::static_stability_factor);
    const double unsprung = draft.mass_kg - v.mass.sprung_kg;
    g.cg_height_m = (draft.mass_kg * height - unsprung * g.wheel_radius_m) / v.mass.sprung_kg;
    draft.wheelbase_m = wheelbase;
}

void draw_inertias(VehicleDraft& draft) {
    VehicleParameters& v = draft.vehicle;
    const auto squared = [](double x) { return x * x; };
    const double track = v.geometry.track_width_m;
    InertiaParameters& i = v.inertia;
    i.sprung_roll_kgm2 =
        v.mass.sprung_kg *
        squared(track * draft.within(Quantity::roll_gyration, &VehicleClass::roll_gyration_of_track));
    i.sprung_pitch_kgm2 =
        v.mass.sprung_kg *
        squared(draft.wheelbase_m *
                draft.within(Quantity::pitch_gyration, &VehicleClass::pitch_gyration_of_wheelbase));
    i.sprung_yaw_kgm2 = v.mass.sprung_kg *
                        squared(draft.wheelbase_m * draft.within(Quantity::yaw_gyration,
                                                                 &VehicleClass::yaw_gyration_of_wheelbase));
    i.rear_axle_kgm2 = v.mass.rear_axle_kg * squared(axle_gyration_share * 0.5 * track);
    i.wheel_spin_kgm2 = rotor_mass_share * v.mass.front_unsprung_kg * squared(v.geometry.wheel_radius_m);
}

}  // namespace sil
