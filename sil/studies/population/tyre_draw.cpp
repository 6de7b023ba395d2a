// Tyre draw: stiffness, forces, and the friction that the vehicle's threshold asks for.
#include <algorithm>
#include <cmath>

#include "sil/studies/population/properties.hpp"
#include "sil/studies/population/vehicle_draft.hpp"

namespace sil {

void draw_tyre_stiffness(VehicleDraft& draft) {
    VehicleParameters& v = draft.vehicle;
    const double deflection = draft.within(Quantity::tyre_deflection, &VehicleClass::tyre_deflection_m);
    v.tyre.vertical_stiffness_npm = 0.25 * g_mps2 * draft.mass_kg / deflection;
    // A few per cent of critical, at the wheel's own frequency.
    v.tyre.vertical_damping_nspm = 0.06 * std::sqrt(v.tyre.vertical_stiffness_npm * v.mass.front_unsprung_kg);
}

void draw_tyre_forces(VehicleDraft& draft) {
    VehicleParameters& v = draft.vehicle;
    TyreParameters& t = v.tyre;
    const double static_n = 0.25 * g_mps2 * draft.mass_kg;
    t.cornering_stiffness_load_n =
        std::max(draft.front_wheel_n(), draft.rear_wheel_n()) *
        draft.within(Quantity::cornering_peak, &VehicleClass::cornering_peak_over_load);
    const double x = static_n / t.cornering_stiffness_load_n;
    t.cornering_stiffness_nprad = static_n *
                                  draft.within(Quantity::cornering, &VehicleClass::cornering_per_load_prad) *
                                  (1.0 + x * x) / (2.0 * x);
    t.slip_stiffness_ratio = draft.within(Quantity::slip_stiffness, &VehicleClass::slip_stiffness_ratio);
    t.shape = draft.within(Quantity::shape, &VehicleClass::shape);
    t.curvature = draft.within(Quantity::curvature, &VehicleClass::curvature);
    t.relaxation_length_m = draft.within(Quantity::relaxation, &VehicleClass::relaxation_length_m);
    t.camber_thrust_prad = draft.within(Quantity::camber_thrust, &VehicleClass::camber_thrust_prad);
    t.lateral_compliance_mpn =
        draft.within(Quantity::lateral_deflection, &VehicleClass::lateral_deflection_m) / static_n;
    t.rolling_resistance = draft.within(Quantity::rolling_resistance, &VehicleClass::rolling_resistance);
    t.front_friction_factor = draft.within(Quantity::front_friction, &VehicleClass::front_friction_factor);
    t.rear_friction_factor = draft.within(Quantity::rear_friction, &VehicleClass::rear_friction_factor);
}

// Friction at the load F is a - b F; its loss by doubling the static load is drawn, and what is left then.
void draw_grip(VehicleDraft& draft) {
    VehicleParameters& v = draft.vehicle;
    const double wanted =
        properties(v).threshold_g * draft.within(Quantity::grip, &VehicleClass::grip_over_threshold);
    const double at_double_load = std::clamp(wanted, draft.from.friction.lowest, draft.from.friction.highest);
    const double loss = draft.within(Quantity::friction_loss, &VehicleClass::friction_loss);
    const double static_n = 0.25 * g_mps2 * draft.mass_kg;
    const double at_static_load = at_double_load / (1.0 - loss);
    const double slope_pn = loss * at_static_load / static_n;
    const double at_no_load = at_static_load + slope_pn * static_n;
    constexpr double reference_load_n = 6000.0;  // of TyreParameters
    v.tyre.friction = at_no_load - reference_load_n * slope_pn;
    v.tyre.friction_load_sensitivity = reference_load_n * slope_pn / v.tyre.friction;
}

}  // namespace sil
