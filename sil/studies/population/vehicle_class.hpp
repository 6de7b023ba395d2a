// Vehicle class: between which ends the vehicles of one class lie.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sil/studies/campaign/settings.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Load that such a vehicle carries at times, unknown to the firmware.
struct ClassLoad {
    double mass_kg{0.0};  // either this at a height above the road
    double height_m{0.0};
    double mass_share{0.0};     // or this share of the total mass
    double height_factor{0.0};  // times the height of the sprung CG
};

// Field names are the keys of classes.toml, which says what they are and why.
struct VehicleClass {
    std::string name{};
    double max_speed_kmh{};
    ClassLoad load{};
    bool mass_sensor{};  // its axle loads are on the bus

    Interval mass_kg{};
    Interval wheelbase_m{};
    Interval track_width_m{};
    Interval static_stability_factor{};  // half the track over the CG height of the whole vehicle
    Interval front_load_share{};
    Interval unsprung_share{};
    Interval wheel_radius_m{};
    Interval roll_gyration_of_track{};
    Interval pitch_gyration_of_wheelbase{};
    Interval yaw_gyration_of_wheelbase{};
    Interval rigid_front_share{};  // of the vehicles; both ends alike
    Interval rigid_rear_share{};
    Interval independent_roll_centre_m{};
    Interval rigid_front_roll_centre_m{};
    Interval rigid_rear_roll_centre_m{};
    Interval front_ride_frequency_hz{};
    Interval rear_over_front_frequency{};
    Interval rigid_spring_base_of_track{};
    Interval roll_gradient_degpg{};  // of the body on its suspension
    Interval front_roll_stiffness_share{};
    Interval bump_damping_ratio{};
    Interval rebound_over_bump{};
    Interval early_stop_share{};  // of the axles
    Interval early_clearance_m{};
    Interval clearance_m{};
    Interval stop_over_spring_pm{};
    Interval spring_progression{};         // growth of the stiffness by a deflection of 80 mm, as a share
    Interval leaf_spring_share{};          // of the vehicles, on their rigid axles; both ends alike
    Interval leaf_friction{};              // of a leaf spring, over its static load
    Interval twisting_frame_share{};       // of the vehicles; both ends alike
    Interval frame_over_roll_stiffness{};  // torsional stiffness over that of both suspensions
    Interval frame_damping_ratio{};
    Interval frame_rear_share{};         // of the sprung mass, behind the frame
    Interval tyre_deflection_m{};        // under the static load
    Interval cornering_per_load_prad{};  // cornering stiffness over load, both static
    Interval
        cornering_peak_over_load{};  // the load of the largest cornering stiffness over the larger static one
    Interval
        compliance_understeer_s2pm{};  // the part of the understeer that comes from the steering giving way
    Interval understeer_gradient_s2pm{};  // not drawn; refuses what handles as no such vehicle does
                                          // vehicle does
    Interval relaxation_length_m{};
    Interval camber_thrust_prad{};
    Interval lateral_deflection_m{};  // of the tyre, at 1 g
    Interval
        grip_over_threshold{};  // friction over the lateral acceleration in g that lifts the inner wheels
    Interval friction{};        // of the class's tyres; it bounds the former
    Interval friction_loss{};
    Interval front_friction_factor{};
    Interval rear_friction_factor{};
    Interval shape{};
    Interval curvature{};
    Interval slip_stiffness_ratio{};
    Interval rolling_resistance{};
    Interval steering_ratio{};
    Interval steering_lag_s{};
    Interval imu_height_m{};
    Interval imu_forward_of_wheelbase{};  // of the CG
    Interval imu_left_m{};
    Interval body_height_m{};
    Interval length_over_wheelbase{};
    Interval drag_area_m2{};
    Interval front_drive_share{};
};

// Throws InputError with file, line and key for anything that cannot be read, is missing or unknown.
std::vector<VehicleClass> parse_vehicle_classes(std::string_view text, const std::string& name);

// Those of sil/studies/population/classes.toml.
const std::vector<VehicleClass>& vehicle_classes();

// The vehicle with the load that its class carries at times.
VehicleParameters loaded(const VehicleParameters& vehicle, const ClassLoad& load);

}  // namespace sil
