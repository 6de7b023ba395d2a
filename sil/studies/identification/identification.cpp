#include "sil/studies/identification/identification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sil/studies/identification/warnings.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double largest_lateral_mps2 = 1.1 * g_mps2;
constexpr double smallest_damping_time_s = 0.005;  // c_f / K_f that the component admits

std::vector<PreparedDrive> prepare_all(const std::vector<Drive>& drives, const VehicleData& vehicle,
                                       const PreparationOptions& options) {
    std::vector<PreparedDrive> prepared;
    for (const Drive& drive : drives) {
        prepared.push_back(prepare_drive(drive, vehicle, options));
    }
    return prepared;
}

double assumed_roll_centre_m(const VehicleData& vehicle) {
    return std::min(usual_roll_centre_m, 0.5 * vehicle.sprung_cg_height_m);
}

void use_loads(Identification& result) {
    LoadFit& loads = *result.loads;
    if (loads.cg_height_m != result.given_cg_height_m) {
        match_dynamic_loads(result.vehicle, result.roll, result.ramps, result.dynamics, loads);
    }
    result.roll_centre_height_m = loads.roll_centre_height_m;
    result.roll_centre_origin = fmt::format(
        "effective, fitted to the wheel loads, +-{:.3f} for a CG height known to 1 %", loads.deviation_m);
    if (loads.cg_height_m != result.given_cg_height_m) {
        result.vehicle.sprung_cg_height_m = loads.cg_height_m;
        result.cg_height_origin =
            fmt::format("matched to the wheel loads; vehicle data {:.4g}", result.given_cg_height_m);
    }
}

void choose_roll_centre(Identification& result) {
    VehicleData& vehicle = result.vehicle;
    result.given_cg_height_m = vehicle.sprung_cg_height_m;
    result.cg_height_origin = "vehicle data";
    result.loads = fit_loads(vehicle, result.ramps);
    if (vehicle.roll_centre_height_m) {
        result.roll_centre_height_m = *vehicle.roll_centre_height_m;
        result.roll_centre_origin = "vehicle data";
    } else if (result.loads && !result.loads->contradicts_data) {
        use_loads(result);
    } else {
        result.roll_centre_height_m = assumed_roll_centre_m(vehicle);
        result.roll_centre_origin = "ASSUMED: neither data sheet nor wheel loads tell it";
    }
    result.roll = result.roll.with_arm(vehicle.sprung_cg_height_m - result.roll_centre_height_m);
    for (const auto* drives : {&result.ramps, &result.dynamics}) {
        for (const DriveResidual& residual : load_transfer_residuals(vehicle, result.roll, *drives)) {
            result.load_transfer.push_back(residual);
        }
    }
}

double largest_parallel(const Identification& result) {
    double largest = 0.0;
    for (const auto* drives : {&result.ramps, &result.dynamics}) {
        for (const PreparedDrive& drive : *drives) {
            largest = std::max(largest, drive.largest_parallel_mps2);
        }
    }
    return largest;
}

std::string fitted(const Estimate& estimate, const char* format) {
    return fmt::format("fitted, +-{}", fmt::format(fmt::runtime(format), estimate.deviation));
}

void add_vehicle(Identification& result) {
    const VehicleData& vehicle = result.vehicle;
    auto& values = result.values;
    values.push_back({"sprung_mass_kg", vehicle.sprung_mass_kg, "vehicle data"});
    values.push_back({"sprung_cg_height_m", vehicle.sprung_cg_height_m, result.cg_height_origin});
    values.push_back({"track_width_m", vehicle.track_width_m, "vehicle data"});
    values.push_back({"unsprung_mass_kg", vehicle.unsprung_mass_kg, "vehicle data"});
    values.push_back({"unsprung_cg_height_m", vehicle.unsprung_cg_height_m, "vehicle data"});
    values.push_back({"wheelbase_m", vehicle.wheelbase_m, "vehicle data"});
    values.push_back({"imu_x_m", vehicle.imu_x_m, "vehicle data"});
    values.push_back({"imu_y_m", vehicle.imu_y_m, "vehicle data"});
    values.push_back({"imu_z_m", vehicle.imu_z_m, "vehicle data"});
}

void add_roll(Identification& result) {
    const RollFit& roll = result.roll;
    auto& values = result.values;
    values.push_back({"roll_inertia_kgm2", roll.inertia_kgm2.value, fitted(roll.inertia_kgm2, "{:.0f}")});
    values.push_back({"fixed_roll_centre_height_m", result.roll_centre_height_m, result.roll_centre_origin});
    values.push_back(
        {"roll_stiffness_nmprad", roll.stiffness_nmprad.value, fitted(roll.stiffness_nmprad, "{:.0f}")});
    const double smallest = 1.01 * smallest_damping_time_s * roll.stiffness_nmprad.value;
    const bool too_small = roll.damping_nmsprad.value < smallest;
    values.push_back(
        {"roll_damping_nmsprad", std::max(roll.damping_nmsprad.value, smallest),
         too_small ? "the least that the component admits" : fitted(roll.damping_nmsprad, "{:.0f}")});
    values.push_back({"roll_stiffness_cubic_nmprad3", roll.stiffness_cubic_nmprad3.value,
                      fitted(roll.stiffness_cubic_nmprad3, "{:.2g}")});
    values.push_back({"roll_stiffness_quintic_nmprad5", roll.stiffness_quintic_nmprad5.value,
                      fitted(roll.stiffness_quintic_nmprad5, "{:.2g}")});
}

void add_steering(Identification& result) {
    const VehicleData& vehicle = result.vehicle;
    auto& values = result.values;
    if (result.steering) {
        const SteeringFit& steering = *result.steering;
        values.push_back({"steering_ratio", steering.ratio.value,
                          steering.ratio_fitted ? fitted(steering.ratio, "{:.2f}") : "vehicle data"});
        values.push_back({"understeer_gradient_s2pm", steering.understeer_gradient_s2pm.value,
                          steering.gradient_fitted ? fitted(steering.understeer_gradient_s2pm, "{:.5f}")
                          : vehicle.understeer_gradient_s2pm ? "vehicle data"
                                                             : "ASSUMED: one speed tells only one of both"});
    } else {
        values.push_back({"steering_ratio", vehicle.steering_ratio.value_or(17.0),
                          vehicle.steering_ratio ? "vehicle data" : "ASSUMED"});
        values.push_back({"understeer_gradient_s2pm",
                          vehicle.understeer_gradient_s2pm.value_or(usual_understeer_gradient_s2pm),
                          vehicle.understeer_gradient_s2pm ? "vehicle data" : "ASSUMED"});
    }
    const double seen = 1.05 * largest_parallel(result);
    values.push_back({"largest_lateral_acceleration_mps2", std::max(largest_lateral_mps2, seen),
                      seen > largest_lateral_mps2 ? "5 % above the largest seen" : "1.1 g: a dry road"});
}

// Where the printed threshold is reached in a slow turn: A/N = T on the fitted curve.
void add_rollover_index(Identification& result) {
    const VehicleData& vehicle = result.vehicle;
    const RollFit& roll = result.roll;
    const double weight_moment = vehicle.sprung_mass_kg * roll.arm_m * g_mps2;
    double low = 0.0, high = 0.5;
    for (int k = 0; k < 50; ++k) {
        const double phi = 0.5 * (low + high);
        const double acceleration = roll.moment_nm(phi) / weight_moment - std::tan(phi);  // in g
        const double threshold =
            (0.5 * vehicle.track_width_m - roll.arm_m * std::tan(phi)) / vehicle.sprung_cg_height_m;
        (acceleration < threshold ? low : high) = phi;
    }
    const double acceleration =
        g_mps2 * (0.5 * vehicle.track_width_m - roll.arm_m * std::tan(low)) / vehicle.sprung_cg_height_m;
    result.values.push_back(
        {"rollover_index_roll_angle_rad", low, "roll angle at the threshold in a slow turn"});
    result.values.push_back({"rollover_index_acceleration_mps2", acceleration,
                             "lateral acceleration at the threshold in a slow turn"});
}

}  // namespace

Identification identify(const VehicleData& vehicle, const std::vector<Drive>& ramps,
                        const std::vector<Drive>& dynamics, const PreparationOptions& options) {
    if (ramps.empty() || dynamics.empty()) {
        throw IdentificationError(
            "a slow ramp and a dynamic drive are both needed: the one gives the stiffness, the other damping "
            "and "
            "inertia");
    }
    Identification result;
    result.vehicle = vehicle;
    result.ramps = prepare_all(ramps, vehicle, options);
    result.dynamics = prepare_all(dynamics, vehicle, options);
    const double assumed_arm_m =
        vehicle.sprung_cg_height_m - vehicle.roll_centre_height_m.value_or(assumed_roll_centre_m(vehicle));
    result.roll = fit_roll(vehicle, assumed_arm_m, result.ramps, result.dynamics);
    choose_roll_centre(result);
    result.steering = fit_steering(vehicle, result.ramps);
    add_vehicle(result);
    add_roll(result);
    add_steering(result);
    add_rollover_index(result);
    result.warnings = identification_warnings(result);
    return result;
}

}  // namespace sil
