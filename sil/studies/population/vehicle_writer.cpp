#include "sil/studies/population/vehicle_writer.hpp"

#include <fmt/format.h>

#include <utility>

#include "sil/files/toml_text.hpp"

namespace sil {
namespace {

class Toml {
 public:
    explicit Toml(std::string head) : text_{std::move(head)} {}

    Toml& table(std::string_view name) {
        text_ += fmt::format("\n[{}]\n", name);
        return *this;
    }
    Toml& number(std::string_view key, double value) {
        text_ += fmt::format("{} = {}\n", key, toml_number(value));
        return *this;
    }
    const std::string& text() const { return text_; }

 private:
    std::string text_;
};

void put(Toml& toml, const SpringDamperParameters& p) {
    toml.number("spring_npm", p.spring_npm)
        .number("jounce_clearance_m", p.jounce_clearance_m)
        .number("rebound_clearance_m", p.rebound_clearance_m)
        .number("jounce_stop_npm2", p.jounce_stop_npm2)
        .number("rebound_stop_npm2", p.rebound_stop_npm2)
        .number("damper_bump_nspm", p.damper_bump_nspm)
        .number("damper_rebound_nspm", p.damper_rebound_nspm);
}

void put_body(Toml& toml, const VehicleParameters& v) {
    toml.table("mass")
        .number("sprung_kg", v.mass.sprung_kg)
        .number("front_unsprung_kg", v.mass.front_unsprung_kg)
        .number("rear_axle_kg", v.mass.rear_axle_kg);
    toml.table("inertia")
        .number("sprung_roll_kgm2", v.inertia.sprung_roll_kgm2)
        .number("sprung_pitch_kgm2", v.inertia.sprung_pitch_kgm2)
        .number("sprung_yaw_kgm2", v.inertia.sprung_yaw_kgm2)
        .number("rear_axle_kgm2", v.inertia.rear_axle_kgm2)
        .number("wheel_spin_kgm2", v.inertia.wheel_spin_kgm2);
    toml.table("geometry")
        .number("front_axle_to_cg_m", v.geometry.front_axle_to_cg_m)
        .number("rear_axle_to_cg_m", v.geometry.rear_axle_to_cg_m)
        .number("track_width_m", v.geometry.track_width_m)
        .number("cg_height_m", v.geometry.cg_height_m)
        .number("wheel_radius_m", v.geometry.wheel_radius_m);
}

void put_suspensions(Toml& toml, const VehicleParameters& v) {
    const FrontSuspensionParameters& front = v.front_suspension;
    put(toml.table("front_suspension"), front.spring_damper);
    toml.number("anti_roll_bar_npm", front.anti_roll_bar_npm)
        .number("path_slope_0", front.path_slope_0)
        .number("path_slope_1_pm", front.path_slope_1_pm)
        .number("path_slope_2_pm2", front.path_slope_2_pm2)
        .number("camber_gain_radpm", front.camber_gain_radpm);
    const RearSuspensionParameters& rear = v.rear_suspension;
    put(toml.table("rear_suspension"), rear.spring_damper);
    toml.number("spring_half_base_m", rear.spring_half_base_m)
        .number("damper_half_base_m", rear.damper_half_base_m)
        .number("anti_roll_bar_nmprad", rear.anti_roll_bar_nmprad)
        .number("panhard_pivot_m", rear.panhard_pivot_m)
        .number("panhard_slope", rear.panhard_slope)
        .number("panhard_length_m", rear.panhard_length_m);
}

void put_tyre(Toml& toml, const TyreParameters& t) {
    toml.table("tyre")
        .number("vertical_stiffness_npm", t.vertical_stiffness_npm)
        .number("vertical_damping_nspm", t.vertical_damping_nspm)
        .number("friction", t.friction)
        .number("front_friction_factor", t.front_friction_factor)
        .number("rear_friction_factor", t.rear_friction_factor)
        .number("friction_load_sensitivity", t.friction_load_sensitivity)
        .number("cornering_stiffness_nprad", t.cornering_stiffness_nprad)
        .number("cornering_stiffness_load_n", t.cornering_stiffness_load_n)
        .number("slip_stiffness_ratio", t.slip_stiffness_ratio)
        .number("shape", t.shape)
        .number("curvature", t.curvature)
        .number("relaxation_length_m", t.relaxation_length_m)
        .number("camber_thrust_prad", t.camber_thrust_prad)
        .number("rolling_resistance", t.rolling_resistance);
}

void put_the_rest(Toml& toml, const VehicleParameters& v) {
    toml.table("steering")
        .number("ratio", v.steering.ratio)
        .number("lag_s", v.steering.lag_s)
        .number("compliance_radpn", v.steering.compliance_radpn);
    toml.table("driveline")
        .number("front_drive_share", v.driveline.front_drive_share)
        .number("drive_force_limit_n", v.driveline.drive_force_limit_n)
        .number("engine_braking_n", v.driveline.engine_braking_n)
        .number("differential_damping_nmsprad", v.driveline.differential_damping_nmsprad)
        .number("front_brake_nm", v.driveline.front_brake_nm)
        .number("rear_brake_nm", v.driveline.rear_brake_nm);
    toml.table("aerodynamics").number("drag_area_m2", v.aerodynamics.drag_area_m2);
    toml.table("hull")
        .number("half_length_m", v.hull.half_length_m)
        .number("half_width_m", v.hull.half_width_m)
        .number("top_above_cg_m", v.hull.top_above_cg_m)
        .number("bottom_below_cg_m", v.hull.bottom_below_cg_m);
    toml.table("imu_mount")
        .number("x_m", v.imu_mount.x_m)
        .number("y_m", v.imu_mount.y_m)
        .number("z_m", v.imu_mount.z_m);
}

}  // namespace

std::string vehicle_toml(const VehicleParameters& vehicle, std::string_view remark) {
    Toml toml{fmt::format("# {}\n\nname = {}\n", remark, toml_string(vehicle.name))};
    put_body(toml, vehicle);
    put_suspensions(toml, vehicle);
    put_tyre(toml, vehicle.tyre);
    put_the_rest(toml, vehicle);
    return toml.text();
}

std::string vehicle_data_toml(const VehicleParameters& vehicle) {
    const GeometryParameters& geometry = vehicle.geometry;
    const double total = total_mass_kg(vehicle);
    Toml toml{fmt::format(
        "# What a data sheet and a workshop say of a drawn vehicle, for rsi-sil identify. SI units.\n\n"
        "name = {}\n",
        toml_string(vehicle.name))};
    toml.number("total_mass_kg", total)
        .number("unsprung_mass_kg", total - vehicle.mass.sprung_kg)
        .number("sprung_cg_height_m", geometry.cg_height_m)
        .number("wheel_radius_m", geometry.wheel_radius_m)
        .number("track_width_m", geometry.track_width_m)
        .number("wheelbase_m", wheelbase_m(geometry))
        .number("steering_ratio", vehicle.steering.ratio)
        .number("imu_x_m", vehicle.imu_mount.x_m)
        .number("imu_y_m", vehicle.imu_mount.y_m)
        .number("imu_z_m", vehicle.imu_mount.z_m);
    return toml.text();
}

}  // namespace sil
