// Vehicle parameters: everything that makes one vehicle differ from another, in SI units.
//
// Static equilibrium on a level road is the design position: there the sprung CG is `cg_height_m` above the
// road, every suspension deflection is zero, and spring preloads follow from the weights. Jounce is positive.
#pragma once

#include <string>

namespace sil {

struct MassParameters {
    double sprung_kg{};
    double front_unsprung_kg{};  // each front wheel with its share of the links
    double rear_axle_kg{};       // the whole axle with both wheels
};

struct InertiaParameters {
    double sprung_roll_kgm2{};  // about the sprung CG
    double sprung_pitch_kgm2{};
    double sprung_yaw_kgm2{};
    double rear_axle_kgm2{};   // roll and yaw of the solid axle about its own centre
    double wheel_spin_kgm2{};  // each wheel about its axis
};

struct GeometryParameters {
    double front_axle_to_cg_m{};  // a, to the sprung CG
    double rear_axle_to_cg_m{};   // b
    double track_width_m{};       // c_w, both axles
    double cg_height_m{};         // h_cg,s above the road
    double wheel_radius_m{};      // of the unloaded tyre
};

// Spring, stops and damper of one wheel. A stop adds rate * (travel beyond its clearance)^2.
struct SpringDamperParameters {
    double spring_npm{};
    double jounce_clearance_m{};
    double rebound_clearance_m{};
    double jounce_stop_npm2{};
    double rebound_stop_npm2{};
    double damper_bump_nspm{};
    double damper_rebound_nspm{};
};

// Independent: the wheel's path in the body has the outward slope Y'(q) = slope_0 - slope_1 q + slope_2 q^2.
struct FrontSuspensionParameters {
    SpringDamperParameters spring_damper{};
    double anti_roll_bar_npm{};  // wheel force per difference of the two deflections
    double path_slope_0{};
    double path_slope_1_pm{};
    double path_slope_2_pm2{};
    double camber_gain_radpm{};  // the wheel's top leans inwards by this much per metre of jounce
};

// Solid axle, located sideways by a Panhard rod: lateral path panhard_slope z + z^2 / (2 panhard_length).
struct RearSuspensionParameters {
    SpringDamperParameters spring_damper{};
    double spring_half_base_m{};
    double damper_half_base_m{};
    double anti_roll_bar_nmprad{};
    double panhard_pivot_m{};  // above the axle's centre
    double panhard_slope{};
    double panhard_length_m{};
};

// Magic Formula with friction mu = mu0 factor (1 - load_sensitivity (F_z / 6000 N - 1)) and cornering
// stiffness c1 sin(2 atan(F_z / c2)).
struct TyreParameters {
    double vertical_stiffness_npm{};
    double vertical_damping_nspm{};
    double friction{};               // mu0
    double front_friction_factor{};  // of mu0, lateral and longitudinal
    double rear_friction_factor{};
    double friction_load_sensitivity{};
    double cornering_stiffness_nprad{};   // c1, the largest
    double cornering_stiffness_load_n{};  // c2, the load at which it is reached
    double slip_stiffness_ratio{};        // longitudinal slip stiffness over cornering stiffness
    double shape{};                       // C
    double curvature{};                   // E
    double relaxation_length_m{};
    double camber_thrust_prad{};  // lateral force per load and radian of camber
    double rolling_resistance{};
};

struct SteeringParameters {
    double ratio{};  // handwheel angle over road wheel angle
    double lag_s{};  // by which the road wheels follow the handwheel; 0: at once
    // By which the road wheels give way to the front axle's lateral force: most of what makes vehicles
    // understeer.
    double compliance_radpn{};
};

struct DrivelineParameters {
    double front_drive_share{};             // 0: rear-wheel drive, 1: front-wheel drive
    double drive_force_limit_n{};           // sum over the wheels
    double engine_braking_n{};              // drag at the wheels when off the throttle
    double differential_damping_nmsprad{};  // torque per difference of speed between the wheels of an axle
    double front_brake_nm{};                // each wheel, at full brake
    double rear_brake_nm{};
};

inline constexpr double air_density_kgpm3 = 1.2;

struct AerodynamicParameters {
    double drag_area_m2{};  // c_d A
};

// Bodywork as a box about the sprung CG; touches the road only when the vehicle has tipped over.
struct HullParameters {
    double half_length_m{};
    double half_width_m{};
    double top_above_cg_m{};
    double bottom_below_cg_m{};
};

// Where the IMU is fixed to the body, from the sprung CG in body axes.
struct ImuMountParameters {
    double x_m{};
    double y_m{};
    double z_m{};
};

struct VehicleParameters {
    std::string name{};
    MassParameters mass{};
    InertiaParameters inertia{};
    GeometryParameters geometry{};
    FrontSuspensionParameters front_suspension{};
    RearSuspensionParameters rear_suspension{};
    TyreParameters tyre{};
    SteeringParameters steering{};
    DrivelineParameters driveline{};
    AerodynamicParameters aerodynamics{};
    HullParameters hull{};
    ImuMountParameters imu_mount{};
};

// Half the track width over the height of the sprung CG, as the paper counts it.
inline double static_stability_factor(const VehicleParameters& parameters) {
    return parameters.geometry.track_width_m / (2.0 * parameters.geometry.cg_height_m);
}

inline double wheelbase_m(const GeometryParameters& geometry) {
    return geometry.front_axle_to_cg_m + geometry.rear_axle_to_cg_m;
}

inline double total_mass_kg(const VehicleParameters& parameters) {
    return parameters.mass.sprung_kg + 2.0 * parameters.mass.front_unsprung_kg + parameters.mass.rear_axle_kg;
}

}  // namespace sil
