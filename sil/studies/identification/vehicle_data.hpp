// Vehicle data: what the data sheet and the workshop say of a vehicle, before any test drive.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sil/input_error.hpp"
#include "sil/world/sensors/sensor_options.hpp"

namespace sil {

// SI units. Heights are above the road, the IMU's place is counted from the sprung mass's centre of gravity
// in body axes (forward, left, up).
struct VehicleData {
    std::string name{};
    double total_mass_kg{};
    double sprung_mass_kg{};
    double unsprung_mass_kg{};
    double sprung_cg_height_m{};
    double unsprung_cg_height_m{};
    double track_width_m{};
    double wheelbase_m{};
    double imu_x_m{};
    double imu_y_m{};
    double imu_z_m{};
    std::optional<double> steering_ratio{};
    std::optional<double> understeer_gradient_s2pm{};
    std::optional<double> roll_centre_height_m{};
    std::optional<double> roll_inertia_kgm2{};            // of the sprung mass about its centre of gravity
    std::optional<RollReference> roll_angle_reference{};  // of the roll sensor; the road where not given
    std::vector<std::string> assumptions{};               // missing values and their substitutes, in words
};

// c_w / (2 h) of the sprung mass.
inline double static_stability_factor(const VehicleData& vehicle) {
    return vehicle.track_width_m / (2.0 * vehicle.sprung_cg_height_m);
}

// m_s h + m_u h_u, of the whole vehicle.
inline double height_moment_kgm(const VehicleData& vehicle) {
    return vehicle.sprung_mass_kg * vehicle.sprung_cg_height_m +
           vehicle.unsprung_mass_kg * vehicle.unsprung_cg_height_m;
}

// The keys are those of docs/calibration.md. `file` may be empty when `settings` ("KEY=VALUE") give all;
// a setting replaces the file's value. Throws InputError.
VehicleData load_vehicle_data(const std::filesystem::path& file,
                              const std::vector<std::string>& settings = {});

}  // namespace sil
