// Parameter file: which keys there are and which values make sense.
#include "sil/world/vehicle/parameter_file.hpp"

#include "sil/files/toml_table.hpp"

namespace sil {
namespace {

MassParameters read_mass(TomlTable table) {
    MassParameters p;
    p.sprung_kg = table.number("sprung_kg", {100.0, 100.0e3});
    p.front_unsprung_kg = table.number("front_unsprung_kg", {1.0, 5.0e3});
    p.rear_axle_kg = table.number("rear_axle_kg", {1.0, 10.0e3});
    table.refuse_unknown_keys();
    return p;
}

InertiaParameters read_inertia(TomlTable table) {
    InertiaParameters p;
    p.sprung_roll_kgm2 = table.number("sprung_roll_kgm2", {10.0, 1.0e6});
    p.sprung_pitch_kgm2 = table.number("sprung_pitch_kgm2", {10.0, 1.0e6});
    p.sprung_yaw_kgm2 = table.number("sprung_yaw_kgm2", {10.0, 1.0e6});
    p.rear_axle_kgm2 = table.number("rear_axle_kgm2", {1.0, 1.0e4});
    p.wheel_spin_kgm2 = table.number("wheel_spin_kgm2", {0.1, 100.0});
    table.refuse_unknown_keys();
    return p;
}

GeometryParameters read_geometry(TomlTable table) {
    GeometryParameters p;
    p.front_axle_to_cg_m = table.number("front_axle_to_cg_m", {0.2, 10.0});
    p.rear_axle_to_cg_m = table.number("rear_axle_to_cg_m", {0.2, 10.0});
    p.track_width_m = table.number("track_width_m", {0.5, 4.0});
    p.cg_height_m = table.number("cg_height_m", {0.2, 4.0});
    p.wheel_radius_m = table.number("wheel_radius_m", {0.1, 1.5});
    table.refuse_unknown_keys();
    return p;
}

SpringDamperParameters read_spring_damper(TomlTable& table) {
    SpringDamperParameters p;
    p.spring_npm = table.number("spring_npm", {1.0e3, 2.0e6});
    p.jounce_clearance_m = table.number("jounce_clearance_m", {0.0, 1.0});
    p.rebound_clearance_m = table.number("rebound_clearance_m", {0.0, 1.0});
    p.jounce_stop_npm2 = table.number("jounce_stop_npm2", {0.0, 50.0e6});
    p.rebound_stop_npm2 = table.number("rebound_stop_npm2", {0.0, 50.0e6});
    p.damper_bump_nspm = table.number("damper_bump_nspm", {0.0, 500.0e3});
    p.damper_rebound_nspm = table.number("damper_rebound_nspm", {0.0, 500.0e3});
    return p;
}

FrontSuspensionParameters read_front_suspension(TomlTable table) {
    FrontSuspensionParameters p;
    p.spring_damper = read_spring_damper(table);
    p.anti_roll_bar_npm = table.number("anti_roll_bar_npm", {0.0, 1.0e6});
    p.path_slope_0 = table.number("path_slope_0", {-1.0, 1.0});
    p.path_slope_1_pm = table.number("path_slope_1_pm", {-20.0, 20.0});
    p.path_slope_2_pm2 = table.number("path_slope_2_pm2", {-100.0, 100.0});
    p.camber_gain_radpm = table.number("camber_gain_radpm", {-2.0, 2.0});
    table.refuse_unknown_keys();
    return p;
}

RearSuspensionParameters read_rear_suspension(TomlTable table) {
    RearSuspensionParameters p;
    p.spring_damper = read_spring_damper(table);
    p.spring_half_base_m = table.number("spring_half_base_m", {0.1, 2.0});
    p.damper_half_base_m = table.number("damper_half_base_m", {0.1, 2.0});
    p.anti_roll_bar_nmprad = table.number("anti_roll_bar_nmprad", {0.0, 10.0e6});
    p.panhard_pivot_m = table.number("panhard_pivot_m", {-0.5, 0.5});
    p.panhard_slope = table.number("panhard_slope", {-0.5, 0.5});
    p.panhard_length_m = table.number("panhard_length_m", {0.2, 3.0});
    table.refuse_unknown_keys();
    return p;
}

TyreParameters read_tyre(TomlTable table) {
    TyreParameters p;
    p.vertical_stiffness_npm = table.number("vertical_stiffness_npm", {50.0e3, 2.0e6});
    p.vertical_damping_nspm = table.number("vertical_damping_nspm", {0.0, 10.0e3});
    p.friction = table.number("friction", {0.05, 2.0});
    p.front_friction_factor = table.number("front_friction_factor", {0.1, 2.0});
    p.rear_friction_factor = table.number("rear_friction_factor", {0.1, 2.0});
    p.friction_load_sensitivity = table.number("friction_load_sensitivity", {0.0, 0.3});
    p.cornering_stiffness_nprad = table.number("cornering_stiffness_nprad", {1.0e3, 2.0e6});
    p.cornering_stiffness_load_n = table.number("cornering_stiffness_load_n", {500.0, 200.0e3});
    p.slip_stiffness_ratio = table.number("slip_stiffness_ratio", {0.2, 5.0});
    p.shape = table.number("shape", {1.0, 2.0});
    p.curvature = table.number("curvature", {-10.0, 1.0});
    p.relaxation_length_m = table.number("relaxation_length_m", {0.05, 3.0});
    p.camber_thrust_prad = table.number("camber_thrust_prad", {0.0, 2.0});
    p.rolling_resistance = table.number("rolling_resistance", {0.0, 0.1});
    table.refuse_unknown_keys();
    return p;
}

SteeringParameters read_steering(TomlTable table) {
    SteeringParameters p;
    p.ratio = table.number("ratio", {1.0, 60.0});
    p.lag_s = table.has("lag_s") ? table.number("lag_s", {0.0, 1.0}) : 0.0;
    table.refuse_unknown_keys();
    return p;
}

DrivelineParameters read_driveline(TomlTable table) {
    DrivelineParameters p;
    p.front_drive_share = table.number("front_drive_share", {0.0, 1.0});
    p.drive_force_limit_n = table.number("drive_force_limit_n", {0.0, 200.0e3});
    p.engine_braking_n = table.number("engine_braking_n", {0.0, 20.0e3});
    p.differential_damping_nmsprad = table.number("differential_damping_nmsprad", {0.0, 500.0});
    p.front_brake_nm = table.number("front_brake_nm", {0.0, 50.0e3});
    p.rear_brake_nm = table.number("rear_brake_nm", {0.0, 50.0e3});
    table.refuse_unknown_keys();
    return p;
}

AerodynamicParameters read_aerodynamics(TomlTable table) {
    AerodynamicParameters p;
    p.drag_area_m2 = table.number("drag_area_m2", {0.0, 20.0});
    table.refuse_unknown_keys();
    return p;
}

HullParameters read_hull(TomlTable table) {
    HullParameters p;
    p.half_length_m = table.number("half_length_m", {0.5, 10.0});
    p.half_width_m = table.number("half_width_m", {0.3, 3.0});
    p.top_above_cg_m = table.number("top_above_cg_m", {0.1, 4.0});
    p.bottom_below_cg_m = table.number("bottom_below_cg_m", {0.0, 3.0});
    table.refuse_unknown_keys();
    return p;
}

ImuMountParameters read_imu_mount(TomlTable table) {
    ImuMountParameters p;
    p.x_m = table.number("x_m", {-10.0, 10.0});
    p.y_m = table.number("y_m", {-2.0, 2.0});
    p.z_m = table.number("z_m", {-3.0, 3.0});
    table.refuse_unknown_keys();
    return p;
}

}  // namespace

VehicleParameters load_vehicle(const std::filesystem::path& path) {
    TomlTable top = TomlTable::load(path);
    VehicleParameters p;
    p.name = top.text("name");
    p.mass = read_mass(top.table("mass"));
    p.inertia = read_inertia(top.table("inertia"));
    p.geometry = read_geometry(top.table("geometry"));
    p.front_suspension = read_front_suspension(top.table("front_suspension"));
    p.rear_suspension = read_rear_suspension(top.table("rear_suspension"));
    p.tyre = read_tyre(top.table("tyre"));
    p.steering = read_steering(top.table("steering"));
    p.driveline = read_driveline(top.table("driveline"));
    p.aerodynamics = read_aerodynamics(top.table("aerodynamics"));
    p.hull = read_hull(top.table("hull"));
    p.imu_mount = read_imu_mount(top.table("imu_mount"));
    top.refuse_unknown_keys();
    return p;
}

}  // namespace sil
