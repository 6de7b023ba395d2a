#include "sil/studies/population/properties.hpp"

#include <algorithm>
#include <cmath>

#include "sil/units.hpp"
#include "sil/world/manoeuvres/steady_steering.hpp"
#include "sil/world/vehicle/tyre.hpp"

namespace sil {
namespace {

double front_share(const VehicleParameters& v) {
    return v.geometry.rear_axle_to_cg_m / wheelbase_m(v.geometry);
}

double front_wheel_load_n(const VehicleParameters& v) {
    return 0.5 * g_mps2 * (v.mass.sprung_kg * front_share(v) + 2.0 * v.mass.front_unsprung_kg);
}

double rear_wheel_load_n(const VehicleParameters& v) {
    return 0.5 * g_mps2 * (v.mass.sprung_kg * (1.0 - front_share(v)) + v.mass.rear_axle_kg);
}

double roll_centre_height_m(const VehicleParameters& v) {
    const double front = 0.5 * v.geometry.track_width_m * v.front_suspension.path_slope_0;
    const double rear_deflection = rear_wheel_load_n(v) / v.tyre.vertical_stiffness_npm;
    const double rear = v.geometry.wheel_radius_m - rear_deflection + v.rear_suspension.panhard_pivot_m;
    return front_share(v) * front + (1.0 - front_share(v)) * rear;
}

double front_roll_stiffness_nmprad(const VehicleParameters& v) {
    const double track = v.geometry.track_width_m;
    return track * track *
           (0.5 * v.front_suspension.spring_damper.spring_npm + v.front_suspension.anti_roll_bar_npm);
}

double rear_roll_stiffness_nmprad(const VehicleParameters& v) {
    const double base = v.rear_suspension.spring_half_base_m;
    return 2.0 * base * base * v.rear_suspension.spring_damper.spring_npm +
           v.rear_suspension.anti_roll_bar_nmprad;
}

struct BodyRoll {
    double front_rad_pg{};  // of the part with the sensors
    double mean_rad_pg{};   // of the mass
};

// Statics of the two parts on their suspensions, with the frame between them, or of one body.
BodyRoll body_roll(const VehicleParameters& v, double tipping_nm) {
    const double front = front_roll_stiffness_nmprad(v);
    const double rear = rear_roll_stiffness_nmprad(v);
    const double torsion = v.rear_suspension.frame_torsion_nmprad;
    const double share = v.rear_suspension.frame_rear_share;
    if (!v.rear_suspension.frame_twists()) {
        const double roll = tipping_nm / (front + rear - tipping_nm);
        return {roll, roll};
    }
    const double front_tipping = (1.0 - share) * tipping_nm;
    const double rear_tipping = share * tipping_nm;
    const double front_net = front - front_tipping;
    const double rear_net = rear - rear_tipping;
    const double determinant = front_net * rear_net + torsion * (front_net + rear_net);
    if (!(determinant > 0.0)) {
        return {std::nan(""), std::nan("")};  // nothing holds the body up
    }
    const double of_front = (front_tipping * rear_net + torsion * tipping_nm) / determinant;
    const double of_rear = (rear_tipping * front_net + torsion * tipping_nm) / determinant;
    return {of_front, (1.0 - share) * of_front + share * of_rear};
}

double mean_damper_nspm(const SpringDamperParameters& p) {
    return 0.5 * (p.damper_bump_nspm + p.damper_rebound_nspm);
}

double roll_damping_nmsprad(const VehicleParameters& v) {
    const double track = v.geometry.track_width_m;
    const double base = v.rear_suspension.damper_half_base_m;
    return 0.5 * track * track * mean_damper_nspm(v.front_suspension.spring_damper) +
           2.0 * base * base * mean_damper_nspm(v.rear_suspension.spring_damper);
}

// Slip angles of both axles; the front wheels lean with the body, and their camber thrust with them; the
// steering gives way.
double understeer_gradient(const VehicleParameters& v, double roll_rad_pg) {
    const Tyre tyre{v.tyre, 1.0};
    const double front_n = front_wheel_load_n(v);
    const double rear_n = rear_wheel_load_n(v);
    const double front_per_load = tyre.cornering_stiffness_nprad(front_n) / front_n;
    const double rear_per_load = tyre.cornering_stiffness_nprad(rear_n) / rear_n;
    const double jounce_m_pg = 0.5 * v.geometry.track_width_m * roll_rad_pg;
    const double lean_pg = roll_rad_pg - v.front_suspension.camber_gain_radpm * jounce_m_pg;
    const double front_slip_pg = (1.0 + v.tyre.camber_thrust_prad * lean_pg) / front_per_load;
    const double given_way_pg = v.steering.compliance_radpn * 2.0 * front_n;
    return (front_slip_pg + given_way_pg - 1.0 / rear_per_load) / g_mps2;
}

}  // namespace

VehicleProperties properties(const VehicleParameters& v) {
    const double track = v.geometry.track_width_m;
    const double mass = total_mass_kg(v);
    const double sprung = v.mass.sprung_kg;
    const double h = v.geometry.cg_height_m;
    VehicleProperties p;
    p.cg_height_m = (sprung * h + (mass - sprung) * v.geometry.wheel_radius_m) / mass;
    p.static_stability_factor = 0.5 * track / p.cg_height_m;
    p.roll_centre_height_m = roll_centre_height_m(v);
    p.roll_arm_m = h - p.roll_centre_height_m;
    p.roll_stiffness_nmprad = front_roll_stiffness_nmprad(v) + rear_roll_stiffness_nmprad(v);
    const double tipping_nm = sprung * g_mps2 * p.roll_arm_m;
    const BodyRoll roll = body_roll(v, tipping_nm);
    const double roll_rad_pg = roll.front_rad_pg;
    p.roll_gradient_degpg = roll_rad_pg * degrees_per_radian;
    const double inertia = v.inertia.sprung_roll_kgm2 + sprung * p.roll_arm_m * p.roll_arm_m;
    const double angular = std::sqrt(tipping_nm / roll_rad_pg / inertia);
    p.roll_frequency_hz = angular / (2.0 * pi);
    p.roll_damping_ratio = 0.5 * roll_damping_nmsprad(v) / (inertia * angular);
    // Roll of suspension and tyres moves the CG outwards.
    const double tyres_nmprad = track * track * v.tyre.vertical_stiffness_npm;
    const double tyres_rad_pg =
        mass * g_mps2 * p.cg_height_m / (tyres_nmprad - mass * g_mps2 * p.cg_height_m);
    const double tyres_m_pg = 0.25 * mass * g_mps2 * v.tyre.lateral_compliance_mpn;
    const double outwards_m_pg =
        sprung / mass * p.roll_arm_m * roll.mean_rad_pg + p.cg_height_m * tyres_rad_pg + tyres_m_pg;
    p.threshold_g = 0.5 * track / (p.cg_height_m + outwards_m_pg);
    p.understeer_gradient_s2pm = understeer_gradient(v, roll_rad_pg);
    const double share = front_share(v);
    const Tyre front{v.tyre, v.tyre.front_friction_factor};
    const Tyre rear{v.tyre, v.tyre.rear_friction_factor};
    p.grip = share * front.friction(2.0 * front_wheel_load_n(v)) +
             (1.0 - share) * rear.friction(2.0 * rear_wheel_load_n(v));
    return p;
}

double handwheel_for_rad(const VehicleParameters& v, double acceleration_mps2, double speed_mps) {
    // An oversteering vehicle needs ever less angle, and none at its critical speed; a driver still turns by
    // half of what the curve's radius asks for.
    const double gradient = std::max(properties(v).understeer_gradient_s2pm,
                                     -0.5 * wheelbase_m(v.geometry) / (speed_mps * speed_mps));
    return SteadySteering{v, gradient}.handwheel_rad(acceleration_mps2, speed_mps);
}

}  // namespace sil
