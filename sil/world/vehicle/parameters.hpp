// Vehicle parameters: everything that makes one vehicle differ from another, in SI units.
//
// Static equilibrium on a level road is the design position: there the sprung CG is `cg_height_m` above the
// road, every suspension deflection is zero, and spring preloads follow from the weights. Jounce is positive.
//
// `Real` is double for one vehicle, and Lanes for several that are computed at once (lanes.hpp).
#pragma once

#include <string>

namespace sil {

template <typename Real>
struct BasicMassParameters {
    Real sprung_kg{};          // mass on the springs
    Real front_unsprung_kg{};  // each front wheel with its share of the links
    Real rear_axle_kg{};       // the whole axle with both wheels
};
using MassParameters = BasicMassParameters<double>;

template <typename Real>
struct BasicInertiaParameters {
    Real sprung_roll_kgm2{};   // about the sprung CG, of rolling
    Real sprung_pitch_kgm2{};  // of pitching
    Real sprung_yaw_kgm2{};    // of yawing
    Real rear_axle_kgm2{};     // roll and yaw of the solid axle about its own centre
    Real wheel_spin_kgm2{};    // each wheel about its axis
};
using InertiaParameters = BasicInertiaParameters<double>;

template <typename Real>
struct BasicGeometryParameters {
    Real front_axle_to_cg_m{};  // a, from the front axle to the sprung CG
    Real rear_axle_to_cg_m{};   // b, from the rear axle to the sprung CG
    Real track_width_m{};       // c_w, track width of both axles
    Real cg_height_m{};         // h_cg,s, the sprung CG above the road
    Real wheel_radius_m{};      // of the unloaded tyre
};
using GeometryParameters = BasicGeometryParameters<double>;

// Spring, stops and damper of one wheel. A stop adds rate * (travel beyond its clearance)^2. The spring's
// stiffness at the deflection q is spring_npm (1 + progression_pm2 q^2).
template <typename Real>
struct BasicSpringDamperParameters {
    Real spring_npm{};           // stiffness of a spring at the wheel
    Real jounce_clearance_m{};   // travel upwards before the stop
    Real rebound_clearance_m{};  // travel downwards before the stop
    Real jounce_stop_npm2{};     // rate of the upper stop
    Real rebound_stop_npm2{};    // rate of the lower stop
    Real damper_bump_nspm{};     // damping upwards
    Real damper_rebound_nspm{};  // damping downwards
    Real progression_pm2{};      // growth of the stiffness with the square of the deflection
    Real dry_friction{};  // between the leaves of the spring: its largest force over the spring's static load
};
using SpringDamperParameters = BasicSpringDamperParameters<double>;

// Independent: the wheel's path in the body has the outward slope Y'(q) = slope_0 - slope_1 q + slope_2 q^2.
template <typename Real>
struct BasicFrontSuspensionParameters {
    BasicSpringDamperParameters<Real> spring_damper{};
    Real anti_roll_bar_npm{};  // wheel force per difference of the two deflections
    Real path_slope_0{};       // outward slope of the wheel's path in the body
    Real path_slope_1_pm{};    // its decrease with the deflection
    Real path_slope_2_pm2{};   // its growth with the square of the deflection
    Real camber_gain_radpm{};  // the wheel's top leans inwards by this much per metre of jounce
};
using FrontSuspensionParameters = BasicFrontSuspensionParameters<double>;

// Solid axle, located sideways by a Panhard rod: lateral path panhard_slope z + z^2 / (2 panhard_length). It
// carries the rear part of the body, which the frame lets turn about the axle's roll centre.
template <typename Real>
struct BasicRearSuspensionParameters {
    BasicSpringDamperParameters<Real> spring_damper{};
    Real spring_half_base_m{};     // half the distance between the springs
    Real damper_half_base_m{};     // half the distance between the dampers
    Real anti_roll_bar_nmprad{};   // moment per angle between body and axle
    Real panhard_pivot_m{};        // above the axle's centre
    Real panhard_slope{};          // slope of the axle's lateral path
    Real panhard_length_m{};       // length of the Panhard rod
    Real frame_torsion_nmprad{};   // of the frame between the front and the rear part; 0: rigid
    Real frame_damping_nmsprad{};  // damping of that torsion
    Real frame_rear_share{};       // of sprung mass and roll inertia, in the rear part

    auto frame_twists() const { return frame_torsion_nmprad > 0.0 && frame_rear_share > 0.0; }
};
using RearSuspensionParameters = BasicRearSuspensionParameters<double>;

// Magic Formula with friction mu = mu0 factor (1 - load_sensitivity (F_z / 6000 N - 1)) and cornering
// stiffness c1 sin(2 atan(F_z / c2)).
template <typename Real>
struct BasicTyreParameters {
    Real vertical_stiffness_npm{};      // of a tyre under load
    Real vertical_damping_nspm{};       // of a tyre under load
    Real friction{};                    // mu0, coefficient at 6000 N
    Real front_friction_factor{};       // of mu0, lateral and longitudinal
    Real rear_friction_factor{};        // the same of the rear tyres
    Real friction_load_sensitivity{};   // loss of friction with the load
    Real cornering_stiffness_nprad{};   // c1, the largest
    Real cornering_stiffness_load_n{};  // c2, the load at which it is reached
    Real slip_stiffness_ratio{};        // longitudinal slip stiffness over cornering stiffness
    Real shape{};                       // C, shape factor of the Magic Formula
    Real curvature{};                   // E, curvature factor of the Magic Formula
    Real relaxation_length_m{};         // distance in which the lateral force builds up
    Real camber_thrust_prad{};          // lateral force per load and radian of camber
    Real rolling_resistance{};          // drag per load
    Real lateral_compliance_mpn{};  // by which the contact patch gives way under the rim, per lateral force
};
using TyreParameters = BasicTyreParameters<double>;

template <typename Real>
struct BasicSteeringParameters {
    Real ratio{};  // handwheel angle over road wheel angle
    Real lag_s{};  // by which the road wheels follow the handwheel; 0: at once
    // Most of what makes vehicles understeer.
    Real compliance_radpn{};  // by which the road wheels give way to the front axle's lateral force
};
using SteeringParameters = BasicSteeringParameters<double>;

template <typename Real>
struct BasicDrivelineParameters {
    Real front_drive_share{};             // 0: rear-wheel drive, 1: front-wheel drive
    Real drive_force_limit_n{};           // sum over the wheels
    Real engine_braking_n{};              // drag at the wheels when off the throttle
    Real differential_damping_nmsprad{};  // torque per difference of speed between the wheels of an axle
    Real front_brake_nm{};                // each front wheel, at full brake
    Real rear_brake_nm{};                 // each rear wheel, at full brake
};
using DrivelineParameters = BasicDrivelineParameters<double>;

inline constexpr double air_density_kgpm3 = 1.2;

template <typename Real>
struct BasicAerodynamicParameters {
    Real drag_area_m2{};  // c_d A, drag coefficient times frontal area
};
using AerodynamicParameters = BasicAerodynamicParameters<double>;

// Bodywork as a box about the sprung CG; touches the road only when the vehicle has tipped over.
template <typename Real>
struct BasicHullParameters {
    Real half_length_m{};      // half the length of the body
    Real half_width_m{};       // half the width of the body
    Real top_above_cg_m{};     // roof above the sprung CG
    Real bottom_below_cg_m{};  // floor below the sprung CG
};
using HullParameters = BasicHullParameters<double>;

// Position of the IMU on the body, from the sprung CG in body axes.
template <typename Real>
struct BasicImuMountParameters {
    Real x_m{};  // forward
    Real y_m{};  // to the left
    Real z_m{};  // upwards
};
using ImuMountParameters = BasicImuMountParameters<double>;

// A part of the sprung mass that moves sideways in the body: liquid that sloshes on a spring, cargo that
// slides once the lateral force overcomes its friction. No part of a vehicle's file; manoeuvres load it.
template <typename Real>
struct BasicMovingLoadParameters {
    Real mass_kg{};          // at most half of the sprung mass, which contains it; 0: none
    Real above_cg_m{};       // its place over the sprung CG
    Real frequency_radps{};  // of its motion in a body at rest; 0: nothing pulls it back
    Real damping_ratio{};
    Real friction{};  // force that it takes to move it, over its weight
    Real travel_m{};  // to either side; then it meets a wall
};
using MovingLoadParameters = BasicMovingLoadParameters<double>;

// A trailer with one axle, or two close together; its tyres have the vehicle's friction. No part of a
// vehicle's file either.
template <typename Real>
struct BasicTrailerParameters {
    Real mass_kg{};  // 0: none
    Real yaw_inertia_kgm2{};
    Real hitch_behind_cg_m{};  // behind the vehicle's sprung CG
    Real hitch_height_m{};     // above the road
    Real drawbar_m{};          // from the hitch to the trailer's CG
    Real axle_behind_cg_m{};   // of the trailer
};
using TrailerParameters = BasicTrailerParameters<double>;

template <typename Real>
struct BasicVehicleParameters {
    BasicMassParameters<Real> mass{};
    BasicInertiaParameters<Real> inertia{};
    BasicGeometryParameters<Real> geometry{};
    BasicFrontSuspensionParameters<Real> front_suspension{};
    BasicRearSuspensionParameters<Real> rear_suspension{};
    BasicTyreParameters<Real> tyre{};
    BasicSteeringParameters<Real> steering{};
    BasicDrivelineParameters<Real> driveline{};
    BasicAerodynamicParameters<Real> aerodynamics{};
    BasicHullParameters<Real> hull{};
    BasicImuMountParameters<Real> imu_mount{};
    BasicMovingLoadParameters<Real> moving_load{};
    BasicTrailerParameters<Real> trailer{};
};

struct VehicleParameters : BasicVehicleParameters<double> {
    std::string name{};
};

// Half the track width over the height of the sprung CG, as the paper counts it.
inline double static_stability_factor(const VehicleParameters& parameters) {
    return parameters.geometry.track_width_m / (2.0 * parameters.geometry.cg_height_m);
}

template <typename Real>
Real wheelbase_m(const BasicGeometryParameters<Real>& geometry) {
    return geometry.front_axle_to_cg_m + geometry.rear_axle_to_cg_m;
}

template <typename Real>
Real total_mass_kg(const BasicVehicleParameters<Real>& parameters) {
    return parameters.mass.sprung_kg + 2.0 * parameters.mass.front_unsprung_kg + parameters.mass.rear_axle_kg;
}

}  // namespace sil
