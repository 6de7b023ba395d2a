// Suspension draw: roll centres, springs with anti-roll bars and dry friction, dampers and stops, and the
// frame.
#include <algorithm>
#include <cmath>
#include <utility>

#include "sil/studies/population/properties.hpp"
#include "sil/studies/population/vehicle_draft.hpp"

namespace sil {
namespace {

void draw_roll_centres(VehicleDraft& draft) {
    VehicleParameters& v = draft.vehicle;
    FrontSuspensionParameters& front = v.front_suspension;
    RearSuspensionParameters& rear = v.rear_suspension;
    const double half_track = 0.5 * v.geometry.track_width_m;
    const double front_height = draft.within(Quantity::front_roll_centre,
                                             draft.rigid_front ? &VehicleClass::rigid_front_roll_centre_m
                                                               : &VehicleClass::independent_roll_centre_m);
    const double rear_height =
        draft.within(Quantity::rear_roll_centre, draft.rigid_rear ? &VehicleClass::rigid_rear_roll_centre_m
                                                                  : &VehicleClass::independent_roll_centre_m);
    front.path_slope_0 = front_height / half_track;
    // The roll centre of links sinks with the body; a rigid axle's stays, and neither side lifts the body.
    front.path_slope_1_pm = draft.random.within(Quantity::path_change, {0.8, 2.5}) +
                            (draft.rigid_front ? 4.0 * front.path_slope_0 : 0.0);
    front.path_slope_2_pm2 = 1.5;
    // A rigid axle keeps its wheels upright.
    front.camber_gain_radpm =
        draft.rigid_front ? 1.0 / half_track : draft.random.within(Quantity::camber_gain, {0.0, 0.7});
    const double centre = v.geometry.wheel_radius_m - draft.rear_wheel_n() / v.tyre.vertical_stiffness_npm;
    rear.panhard_pivot_m = rear_height - centre;
    rear.panhard_slope = 0.0;
    rear.panhard_length_m =
        draft.rigid_rear ? draft.random.within(Quantity::panhard_length, {0.8, 1.6}) : 3.0;
}

void draw_springs(VehicleDraft& draft) {
    VehicleParameters& v = draft.vehicle;
    FrontSuspensionParameters& front = v.front_suspension;
    RearSuspensionParameters& rear = v.rear_suspension;
    const double track = v.geometry.track_width_m;
    const double front_hz = draft.within(Quantity::front_frequency, &VehicleClass::front_ride_frequency_hz);
    const double rear_hz =
        front_hz * draft.within(Quantity::rear_frequency, &VehicleClass::rear_over_front_frequency);
    const auto rate = [](double hz, double kg) { return 4.0 * pi * pi * hz * hz * kg; };
    front.spring_damper.spring_npm = rate(front_hz, draft.front_sprung_kg());
    rear.spring_damper.spring_npm = rate(rear_hz, draft.rear_sprung_kg());
    const double base = draft.rigid_rear
                            ? draft.within(Quantity::spring_base, &VehicleClass::rigid_spring_base_of_track)
                            : 1.0;
    rear.spring_half_base_m = 0.5 * track * base;
    rear.damper_half_base_m =
        rear.spring_half_base_m *
        (draft.rigid_rear ? draft.random.within(Quantity::damper_base, {0.9, 1.1}) : 1.0);
    // The anti-roll bars provide the stiffness that the springs lack.
    const double tipping_nm = v.mass.sprung_kg * g_mps2 * properties(v).roll_arm_m;
    const double gradient_radpg =
        draft.within(Quantity::roll_gradient, &VehicleClass::roll_gradient_degpg) / degrees_per_radian;
    const double wanted = tipping_nm / gradient_radpg + tipping_nm;
    const double share =
        draft.within(Quantity::front_stiffness_share, &VehicleClass::front_roll_stiffness_share);
    const double front_springs = 0.5 * track * track * front.spring_damper.spring_npm;
    const double rear_springs =
        2.0 * rear.spring_half_base_m * rear.spring_half_base_m * rear.spring_damper.spring_npm;
    front.anti_roll_bar_npm = std::max(0.0, share * wanted - front_springs) / (track * track);
    rear.anti_roll_bar_nmprad = std::max(0.0, (1.0 - share) * wanted - rear_springs);
}

// Progression and dry friction of the springs, and the frame.
void draw_nonlinearities(VehicleDraft& draft) {
    VehicleParameters& v = draft.vehicle;
    constexpr double deflection_m = 0.08;  // to which the progression belongs
    const double progression = draft.within(Quantity::progression, &VehicleClass::spring_progression);
    const bool leaves = draft.random.happens(Quantity::leaf_springs, draft.from.leaf_spring_share);
    const double friction = draft.within(Quantity::dry_friction, &VehicleClass::leaf_friction);
    for (const auto& [spring, rigid] : {std::pair{&v.front_suspension.spring_damper, draft.rigid_front},
                                        std::pair{&v.rear_suspension.spring_damper, draft.rigid_rear}}) {
        spring->progression_pm2 = progression / (deflection_m * deflection_m);
        spring->dry_friction = leaves && rigid ? friction : 0.0;
    }
    if (!draft.random.happens(Quantity::twisting_frame, draft.from.twisting_frame_share)) {
        return;
    }
    RearSuspensionParameters& rear = v.rear_suspension;
    const VehicleProperties rigid = properties(v);
    rear.frame_rear_share = draft.within(Quantity::frame_rear_share, &VehicleClass::frame_rear_share);
    rear.frame_torsion_nmprad =
        rigid.roll_stiffness_nmprad *
        draft.within(Quantity::frame_torsion, &VehicleClass::frame_over_roll_stiffness);
    rear.frame_damping_nmsprad =
        2.0 * draft.within(Quantity::frame_damping, &VehicleClass::frame_damping_ratio) *
        std::sqrt(rear.frame_torsion_nmprad * rear.frame_rear_share * v.inertia.sprung_roll_kgm2);
}

void draw_dampers(VehicleDraft& draft) {
    VehicleParameters& v = draft.vehicle;
    const double ratio = draft.within(Quantity::bump_damping, &VehicleClass::bump_damping_ratio);
    const double rebound = draft.within(Quantity::rebound_damping, &VehicleClass::rebound_over_bump);
    const auto damp = [&](SpringDamperParameters& p, double kg) {
        p.damper_bump_nspm = 2.0 * ratio * std::sqrt(p.spring_npm * kg);
        p.damper_rebound_nspm = rebound * p.damper_bump_nspm;
    };
    damp(v.front_suspension.spring_damper, draft.front_sprung_kg());
    // Nearer to the middle they must be stronger to do the same in roll; designers go half the way.
    RearSuspensionParameters& rear = v.rear_suspension;
    damp(rear.spring_damper, draft.rear_sprung_kg());
    const double lever = 0.5 * v.geometry.track_width_m / rear.damper_half_base_m;
    rear.spring_damper.damper_bump_nspm *= std::max(1.0, lever);
    rear.spring_damper.damper_rebound_nspm *= std::max(1.0, lever);
}

void draw_stops(VehicleDraft& draft) {
    VehicleParameters& v = draft.vehicle;
    const auto stop = [&](SpringDamperParameters& p, Quantity early, Quantity jounce, Quantity rebound,
                          Quantity rate) {
        const Interval& clearance = draft.random.happens(early, draft.from.early_stop_share)
                                        ? draft.from.early_clearance_m
                                        : draft.from.clearance_m;
        p.jounce_clearance_m = draft.random.within(jounce, clearance);
        p.rebound_clearance_m = draft.random.within(rebound, clearance);
        p.jounce_stop_npm2 = p.spring_npm * draft.within(rate, &VehicleClass::stop_over_spring_pm);
        p.rebound_stop_npm2 = 0.7 * p.jounce_stop_npm2;
    };
    stop(v.front_suspension.spring_damper, Quantity::early_front_stop, Quantity::front_jounce_clearance,
         Quantity::front_rebound_clearance, Quantity::front_stop);
    stop(v.rear_suspension.spring_damper, Quantity::early_rear_stop, Quantity::rear_jounce_clearance,
         Quantity::rear_rebound_clearance, Quantity::rear_stop);
}

}  // namespace

void draw_suspension(VehicleDraft& draft) {
    draw_roll_centres(draft);
    draw_springs(draft);
    draw_dampers(draft);
    draw_stops(draft);
    draw_nonlinearities(draft);
}

}  // namespace sil
