// Vehicle classes from TOML: which keys there are.
#include "sil/studies/population/vehicle_class.hpp"

#include <array>

#include "built_in_classes.hpp"
#include "sil/files/toml_table.hpp"
#include "sil/world/vehicle/load.hpp"

namespace sil {
namespace {

struct Key {
    std::string_view name;
    Interval VehicleClass::* member;
};

constexpr Key keys_of_every_class[] = {
    {"pitch_gyration_of_wheelbase", &VehicleClass::pitch_gyration_of_wheelbase},
    {"yaw_gyration_of_wheelbase", &VehicleClass::yaw_gyration_of_wheelbase},
    {"bump_damping_ratio", &VehicleClass::bump_damping_ratio},
    {"rebound_over_bump", &VehicleClass::rebound_over_bump},
    {"rear_over_front_frequency", &VehicleClass::rear_over_front_frequency},
    {"early_stop_share", &VehicleClass::early_stop_share},
    {"early_clearance_m", &VehicleClass::early_clearance_m},
    {"stop_over_spring_pm", &VehicleClass::stop_over_spring_pm},
    {"leaf_friction", &VehicleClass::leaf_friction},
    {"frame_over_roll_stiffness", &VehicleClass::frame_over_roll_stiffness},
    {"frame_damping_ratio", &VehicleClass::frame_damping_ratio},
    {"frame_rear_share", &VehicleClass::frame_rear_share},
    {"friction_loss", &VehicleClass::friction_loss},
    {"front_friction_factor", &VehicleClass::front_friction_factor},
    {"rear_friction_factor", &VehicleClass::rear_friction_factor},
    {"shape", &VehicleClass::shape},
    {"curvature", &VehicleClass::curvature},
    {"slip_stiffness_ratio", &VehicleClass::slip_stiffness_ratio},
    {"rolling_resistance", &VehicleClass::rolling_resistance},
    {"lateral_deflection_m", &VehicleClass::lateral_deflection_m},
};

constexpr Key keys_of_one_class[] = {
    {"mass_kg", &VehicleClass::mass_kg},
    {"wheelbase_m", &VehicleClass::wheelbase_m},
    {"track_width_m", &VehicleClass::track_width_m},
    {"static_stability_factor", &VehicleClass::static_stability_factor},
    {"front_load_share", &VehicleClass::front_load_share},
    {"unsprung_share", &VehicleClass::unsprung_share},
    {"wheel_radius_m", &VehicleClass::wheel_radius_m},
    {"roll_gyration_of_track", &VehicleClass::roll_gyration_of_track},
    {"rigid_front_share", &VehicleClass::rigid_front_share},
    {"rigid_rear_share", &VehicleClass::rigid_rear_share},
    {"independent_roll_centre_m", &VehicleClass::independent_roll_centre_m},
    {"rigid_front_roll_centre_m", &VehicleClass::rigid_front_roll_centre_m},
    {"rigid_rear_roll_centre_m", &VehicleClass::rigid_rear_roll_centre_m},
    {"front_ride_frequency_hz", &VehicleClass::front_ride_frequency_hz},
    {"rigid_spring_base_of_track", &VehicleClass::rigid_spring_base_of_track},
    {"roll_gradient_degpg", &VehicleClass::roll_gradient_degpg},
    {"front_roll_stiffness_share", &VehicleClass::front_roll_stiffness_share},
    {"clearance_m", &VehicleClass::clearance_m},
    {"spring_progression", &VehicleClass::spring_progression},
    {"leaf_spring_share", &VehicleClass::leaf_spring_share},
    {"twisting_frame_share", &VehicleClass::twisting_frame_share},
    {"tyre_deflection_m", &VehicleClass::tyre_deflection_m},
    {"cornering_per_load_prad", &VehicleClass::cornering_per_load_prad},
    {"cornering_peak_over_load", &VehicleClass::cornering_peak_over_load},
    {"compliance_understeer_s2pm", &VehicleClass::compliance_understeer_s2pm},
    {"understeer_gradient_s2pm", &VehicleClass::understeer_gradient_s2pm},
    {"relaxation_length_m", &VehicleClass::relaxation_length_m},
    {"camber_thrust_prad", &VehicleClass::camber_thrust_prad},
    {"grip_over_threshold", &VehicleClass::grip_over_threshold},
    {"friction", &VehicleClass::friction},
    {"steering_ratio", &VehicleClass::steering_ratio},
    {"steering_lag_s", &VehicleClass::steering_lag_s},
    {"imu_height_m", &VehicleClass::imu_height_m},
    {"imu_forward_of_wheelbase", &VehicleClass::imu_forward_of_wheelbase},
    {"imu_left_m", &VehicleClass::imu_left_m},
    {"body_height_m", &VehicleClass::body_height_m},
    {"length_over_wheelbase", &VehicleClass::length_over_wheelbase},
    {"drag_area_m2", &VehicleClass::drag_area_m2},
    {"front_drive_share", &VehicleClass::front_drive_share},
};

template <std::size_t size>
void read(TomlTable& table, const Key (&keys)[size], VehicleClass& values) {
    for (const Key& key : keys) {
        const std::vector<double> ends = table.numbers(key.name);
        if (ends.size() != 2U || ends[0] > ends[1]) {
            table.fail(key.name, "must be two numbers, [lowest, highest]");
        }
        values.*key.member = {ends[0], ends[1]};
    }
}

ClassLoad read_load(TomlTable table) {
    ClassLoad load;
    if (table.has("mass_kg")) {
        load.mass_kg = table.number("mass_kg", {0.0, 1000.0});
        load.height_m = table.number("height_m", {0.0, 5.0});
    } else {
        load.mass_share = table.number("mass_share", {0.0, 1.0});
        load.height_factor = table.number("height_factor", {0.0, 5.0});
    }
    table.refuse_unknown_keys();
    return load;
}

}  // namespace

std::vector<VehicleClass> parse_vehicle_classes(std::string_view text, const std::string& name) {
    TomlTable top = TomlTable::parse(text, name);
    VehicleClass common;
    TomlTable every_class = top.table("every_class");
    read(every_class, keys_of_every_class, common);
    every_class.refuse_unknown_keys();
    std::vector<VehicleClass> classes;
    for (TomlTable& table : top.tables("class")) {
        VehicleClass one = common;
        one.name = table.text("name");
        one.max_speed_kmh = table.number("max_speed_kmh", {30.0, 250.0});
        one.load = read_load(table.table("load"));
        one.mass_sensor = table.boolean("mass_sensor");
        read(table, keys_of_one_class, one);
        table.refuse_unknown_keys();
        classes.push_back(one);
    }
    if (classes.empty()) {
        top.fail("class", "is missing: add at least one");
    }
    top.refuse_unknown_keys();
    return classes;
}

const std::vector<VehicleClass>& vehicle_classes() {
    static const std::vector<VehicleClass> classes =
        parse_vehicle_classes(built_in_classes_text, "built-in vehicle classes");
    return classes;
}

VehicleParameters loaded(const VehicleParameters& vehicle, const ClassLoad& load) {
    if (load.mass_kg > 0.0) {
        return with_load(vehicle, load.mass_kg, load.height_m);
    }
    return with_load(vehicle, load.mass_share * total_mass_kg(vehicle),
                     load.height_factor * vehicle.geometry.cg_height_m);
}

}  // namespace sil
