// Parameter table: every number of a vehicle's parameter file, once: its name, its place and its range.
#pragma once

#include "sil/world/vehicle/parameters.hpp"

namespace sil {

struct VehicleField {
    const char* table;  // of the file
    const char* key;
    double& (*of)(VehicleParameters&);
    double lowest;  // both ends are admitted
    double highest;
    bool may_be_left_out;  // 0 then
};

#define RSI_PLACED(table, place, key, lowest, highest, optional)                                             \
    VehicleField {                                                                                           \
        #table, #key, [](VehicleParameters& p) -> double& { return p.place.key; }, lowest, highest, optional \
    }
#define RSI_FIELD(table, key, lowest, highest) RSI_PLACED(table, table, key, lowest, highest, false)
#define RSI_OPTIONAL(table, key, lowest, highest) RSI_PLACED(table, table, key, lowest, highest, true)
#define RSI_SPRING(table, key, lowest, highest) \
    RSI_PLACED(table, table.spring_damper, key, lowest, highest, false)
#define RSI_OPTIONAL_SPRING(table, key, lowest, highest) \
    RSI_PLACED(table, table.spring_damper, key, lowest, highest, true)
#define RSI_SPRING_DAMPER(table)                                                                            \
    RSI_SPRING(table, spring_npm, 1.0e3, 2.0e6), RSI_SPRING(table, jounce_clearance_m, 0.0, 1.0),           \
        RSI_SPRING(table, rebound_clearance_m, 0.0, 1.0), RSI_SPRING(table, jounce_stop_npm2, 0.0, 50.0e6), \
        RSI_SPRING(table, rebound_stop_npm2, 0.0, 50.0e6),                                                  \
        RSI_SPRING(table, damper_bump_nspm, 0.0, 500.0e3),                                                  \
        RSI_SPRING(table, damper_rebound_nspm, 0.0, 500.0e3),                                               \
        RSI_OPTIONAL_SPRING(table, progression_pm2, 0.0, 500.0),                                            \
        RSI_OPTIONAL_SPRING(table, dry_friction, 0.0, 0.3)

// Table by table.
inline constexpr VehicleField vehicle_fields[] = {
    RSI_FIELD(mass, sprung_kg, 100.0, 100.0e3),
    RSI_FIELD(mass, front_unsprung_kg, 1.0, 5.0e3),
    RSI_FIELD(mass, rear_axle_kg, 1.0, 10.0e3),

    RSI_FIELD(inertia, sprung_roll_kgm2, 10.0, 1.0e6),
    RSI_FIELD(inertia, sprung_pitch_kgm2, 10.0, 1.0e6),
    RSI_FIELD(inertia, sprung_yaw_kgm2, 10.0, 1.0e6),
    RSI_FIELD(inertia, rear_axle_kgm2, 1.0, 1.0e4),
    RSI_FIELD(inertia, wheel_spin_kgm2, 0.1, 100.0),

    RSI_FIELD(geometry, front_axle_to_cg_m, 0.2, 10.0),
    RSI_FIELD(geometry, rear_axle_to_cg_m, 0.2, 10.0),
    RSI_FIELD(geometry, track_width_m, 0.5, 4.0),
    RSI_FIELD(geometry, cg_height_m, 0.2, 4.0),
    RSI_FIELD(geometry, wheel_radius_m, 0.1, 1.5),

    RSI_SPRING_DAMPER(front_suspension),
    RSI_FIELD(front_suspension, anti_roll_bar_npm, 0.0, 1.0e6),
    RSI_FIELD(front_suspension, path_slope_0, -1.0, 1.0),
    RSI_FIELD(front_suspension, path_slope_1_pm, -20.0, 20.0),
    RSI_FIELD(front_suspension, path_slope_2_pm2, -100.0, 100.0),
    RSI_FIELD(front_suspension, camber_gain_radpm, -2.0, 2.0),

    RSI_SPRING_DAMPER(rear_suspension),
    RSI_FIELD(rear_suspension, spring_half_base_m, 0.1, 2.0),
    RSI_FIELD(rear_suspension, damper_half_base_m, 0.1, 2.0),
    RSI_FIELD(rear_suspension, anti_roll_bar_nmprad, 0.0, 10.0e6),
    RSI_FIELD(rear_suspension, panhard_pivot_m, -0.5, 0.5),
    RSI_FIELD(rear_suspension, panhard_slope, -0.5, 0.5),
    RSI_FIELD(rear_suspension, panhard_length_m, 0.2, 3.0),
    RSI_OPTIONAL(rear_suspension, frame_torsion_nmprad, 0.0, 100.0e6),
    RSI_OPTIONAL(rear_suspension, frame_damping_nmsprad, 0.0, 100.0e3),
    RSI_OPTIONAL(rear_suspension, frame_rear_share, 0.0, 0.7),

    RSI_FIELD(tyre, vertical_stiffness_npm, 50.0e3, 2.0e6),
    RSI_FIELD(tyre, vertical_damping_nspm, 0.0, 10.0e3),
    RSI_FIELD(tyre, friction, 0.05, 2.0),
    RSI_FIELD(tyre, front_friction_factor, 0.1, 2.0),
    RSI_FIELD(tyre, rear_friction_factor, 0.1, 2.0),
    RSI_FIELD(tyre, friction_load_sensitivity, 0.0, 0.8),
    RSI_FIELD(tyre, cornering_stiffness_nprad, 1.0e3, 2.0e6),
    RSI_FIELD(tyre, cornering_stiffness_load_n, 500.0, 300.0e3),
    RSI_FIELD(tyre, slip_stiffness_ratio, 0.2, 5.0),
    RSI_FIELD(tyre, shape, 1.0, 2.0),
    RSI_FIELD(tyre, curvature, -10.0, 1.0),
    RSI_FIELD(tyre, relaxation_length_m, 0.05, 3.0),
    RSI_FIELD(tyre, camber_thrust_prad, 0.0, 2.0),
    RSI_FIELD(tyre, rolling_resistance, 0.0, 0.1),
    RSI_OPTIONAL(tyre, lateral_compliance_mpn, 0.0, 1.0e-4),

    RSI_FIELD(steering, ratio, 1.0, 60.0),
    RSI_OPTIONAL(steering, lag_s, 0.0, 1.0),
    RSI_OPTIONAL(steering, compliance_radpn, 0.0, 1.0e-4),

    RSI_FIELD(driveline, front_drive_share, 0.0, 1.0),
    RSI_FIELD(driveline, drive_force_limit_n, 0.0, 200.0e3),
    RSI_FIELD(driveline, engine_braking_n, 0.0, 20.0e3),
    RSI_FIELD(driveline, differential_damping_nmsprad, 0.0, 500.0),
    RSI_FIELD(driveline, front_brake_nm, 0.0, 50.0e3),
    RSI_FIELD(driveline, rear_brake_nm, 0.0, 50.0e3),

    RSI_FIELD(aerodynamics, drag_area_m2, 0.0, 20.0),

    RSI_FIELD(hull, half_length_m, 0.5, 10.0),
    RSI_FIELD(hull, half_width_m, 0.3, 3.0),
    RSI_FIELD(hull, top_above_cg_m, 0.1, 4.0),
    RSI_FIELD(hull, bottom_below_cg_m, 0.0, 3.0),

    RSI_FIELD(imu_mount, x_m, -10.0, 10.0),
    RSI_FIELD(imu_mount, y_m, -2.0, 2.0),
    RSI_FIELD(imu_mount, z_m, -3.0, 3.0),
};

#undef RSI_SPRING_DAMPER
#undef RSI_OPTIONAL_SPRING
#undef RSI_SPRING
#undef RSI_OPTIONAL
#undef RSI_FIELD
#undef RSI_PLACED

}  // namespace sil
