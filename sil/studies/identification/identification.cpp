#include "sil/studies/identification/identification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "rsi/rsi.h"
#include "sil/files/parameter_field.hpp"
#include "sil/studies/identification/admitted_range.hpp"
#include "sil/studies/identification/calibration_default.hpp"
#include "sil/studies/identification/plausibility_checks.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double smallest_damping_time_s = 0.005;  // c_f / K_f that the component admits
// This much more is written at least: either of the two may be corrected.
constexpr double damping_reserve = 1.001 / (1.0 - correction_reserve);
constexpr const char* vehicle_data_origin = "vehicle data";

std::vector<PreparedDrive> prepare_all(const std::vector<Drive>& drives, const VehicleData& vehicle,
                                       const PreparationOptions& options) {
    std::vector<PreparedDrive> prepared;
    for (const Drive& drive : drives) {
        prepared.push_back(prepare_drive(drive, vehicle, options));
    }
    return prepared;
}

// If it is not known. The ratios to H = h - h_rc are fitted, so a lower roll centre makes the computed
// load transfer larger: taken on the road, no lift-off is missed for any roll centre on or above it.
constexpr double assumed_roll_centre_m = 0.0;

// Usual value, between independent suspensions (0 to 0.15 m) and a rigid rear axle (0.3 to 0.5 m): for the
// rules of thumb in the roll fit, which are of absolute size, as long as nothing better is known.
double usual_arm_m(const VehicleData& vehicle) {
    const double usual_roll_centre_m = std::min(0.2, 0.5 * vehicle.sprung_cg_height_m);
    return vehicle.sprung_cg_height_m - vehicle.roll_centre_height_m.value_or(usual_roll_centre_m);
}

std::string roll_centre_origin(const LoadFit& loads, double given_cg_height_m) {
    if (loads.contradicts_data) {
        return fmt::format(
            "the nearest plausible; the wheel loads contradict the CG height and speak for {:.3f}",
            loads.roll_centre_at_given_height_m);
    }
    if (loads.cg_height_m != given_cg_height_m) {
        return "the nearest plausible; the CG height is matched to the wheel loads with it";
    }
    if (loads.agreeing_cg_height_m == given_cg_height_m) {
        return fmt::format("effective, fitted to the wheel loads, +-{:.3f} for a CG height known to 1 %",
                           loads.deviation_m);
    }
    return fmt::format("the nearest to {:.3f}, for which the wheel loads speak",
                       loads.roll_centre_at_given_height_m);
}

void use_loads(Identification& result) {
    const LoadFit& loads = *result.loads;
    if (loads.cg_height_m != result.given_cg_height_m) {
        result.vehicle.sprung_cg_height_m = loads.cg_height_m;
        result.cg_height_origin =
            fmt::format("matched to the wheel loads; vehicle data {:.4g}", result.given_cg_height_m);
    }
    result.roll_centre_height_m = loads.roll_centre_height_m;
    result.roll_centre_origin = roll_centre_origin(loads, result.given_cg_height_m);
}

// The largest magnitude that the component admits of a coefficient of the stiffness curve.
double largest_admitted(float rsi::Parameters::* coefficient) {
    const rsi::ParameterField& field = parameter_field(coefficient);
    return std::min(-within_admitted(coefficient, static_cast<double>(field.minimum)),
                    within_admitted(coefficient, static_cast<double>(field.maximum)));
}

CurveLimits admitted_curve() {
    return {largest_admitted(&rsi::Parameters::roll_stiffness_cubic_nmprad3),
            largest_admitted(&rsi::Parameters::roll_stiffness_quintic_nmprad5)};
}

void choose_roll_centre(Identification& result, bool keep_cg_height) {
    VehicleData& vehicle = result.vehicle;
    result.given_cg_height_m = vehicle.sprung_cg_height_m;
    result.cg_height_origin = vehicle_data_origin;
    result.loads = fit_loads(vehicle, result.ramps, keep_cg_height);
    if (vehicle.roll_centre_height_m) {
        result.roll_centre_height_m = *vehicle.roll_centre_height_m;
        result.roll_centre_origin = vehicle_data_origin;
    } else if (result.loads) {
        use_loads(result);
    } else {
        result.roll_centre_height_m = assumed_roll_centre_m;
        result.roll_centre_origin = "ASSUMED, on the road: neither data sheet nor wheel loads give it";
    }
}

// With the arm that was found: only then it shows up to which angle the curve is needed, and whether the
// component admits its coefficients, which grow with the arm. The rules of thumb take it too where wheel
// loads gave it.
void fit_body(Identification& result, double usual_arm_m) {
    const double arm_m = result.vehicle.sprung_cg_height_m - result.roll_centre_height_m;
    const bool loads_give_it = result.loads && !result.loads->contradicts_data;
    result.roll = fit_roll(result.vehicle, {loads_give_it ? arm_m : usual_arm_m, arm_m}, result.ramps,
                           result.dynamics, admitted_curve());
    for (const auto* drives : {&result.ramps, &result.dynamics}) {
        for (const DriveResidual& residual : load_transfer_residuals(result.vehicle, result.roll, *drives)) {
            result.load_transfer.push_back(residual);
        }
    }
}

// Values from the drives must bear a later correction; the vehicle data were checked as given.
IdentifiedValue correctable(IdentifiedValue value) {
    const auto field =
        std::find_if(rsi::parameter_fields.begin(), rsi::parameter_fields.end(),
                     [&value](const rsi::ParameterField& each) { return value.key == each.name; });
    if (field == rsi::parameter_fields.end() || value.origin == vehicle_data_origin) {
        return value;
    }
    const double admitted = within_admitted(field->member, value.value);
    if (admitted != value.value) {
        value.refused = value.value;
        value.origin = fmt::format("{:.4g} is {}", value.value, outside_admitted);
        value.value = admitted;
    }
    return value;
}

// At once, so that what depends on the value takes the one that is written.
void add(Identification& result, IdentifiedValue value) {
    result.values.push_back(correctable(std::move(value)));
}

std::string fitted(const Estimate& estimate, const char* format) {
    return fmt::format("fitted, +-{}", fmt::format(fmt::runtime(format), estimate.deviation));
}

void add_vehicle(Identification& result) {
    const VehicleData& vehicle = result.vehicle;
    add(result, {"sprung_mass_kg", vehicle.sprung_mass_kg, vehicle_data_origin});
    add(result, {"sprung_cg_height_m", vehicle.sprung_cg_height_m, result.cg_height_origin});
    add(result, {"track_width_m", vehicle.track_width_m, vehicle_data_origin});
    add(result, {"unsprung_mass_kg", vehicle.unsprung_mass_kg, vehicle_data_origin});
    add(result, {"unsprung_cg_height_m", vehicle.unsprung_cg_height_m, vehicle_data_origin});
    add(result, {"wheelbase_m", vehicle.wheelbase_m, vehicle_data_origin});
    add(result, {"imu_x_m", vehicle.imu_x_m, vehicle_data_origin});
    add(result, {"imu_y_m", vehicle.imu_y_m, vehicle_data_origin});
    add(result, {"imu_z_m", vehicle.imu_z_m, vehicle_data_origin});
    if (vehicle.roll_angle_reference) {
        const bool horizon = *vehicle.roll_angle_reference == RollReference::horizon;
        add(result, {"roll_angle_reference",
                     static_cast<double>(horizon ? RSI_ROLL_AGAINST_HORIZON : RSI_ROLL_AGAINST_ROAD),
                     vehicle_data_origin});
    }
}

void add_roll(Identification& result) {
    const RollFit& roll = result.roll;
    add(result, {"roll_inertia_kgm2", roll.inertia_kgm2.value,
                 roll.refused_inertia_kgm2
                     ? fmt::format("{}: the drives alone would give {:.0f}",
                                   result.vehicle.roll_inertia_kgm2 ? vehicle_data_origin : "rule of thumb",
                                   *roll.refused_inertia_kgm2)
                     : fitted(roll.inertia_kgm2, "{:.0f}")});
    add(result, {"fixed_roll_centre_height_m", result.roll_centre_height_m, result.roll_centre_origin});
    add(result,
        {"roll_stiffness_nmprad", roll.stiffness_nmprad.value, fitted(roll.stiffness_nmprad, "{:.0f}")});
    const double smallest = damping_reserve * smallest_damping_time_s * result.value("roll_stiffness_nmprad");
    const bool too_small = roll.damping_nmsprad.value < smallest;
    add(result, {"roll_damping_nmsprad", std::max(roll.damping_nmsprad.value, smallest),
                 too_small ? "the least that the component admits, and a reserve for corrections"
                           : fitted(roll.damping_nmsprad, "{:.0f}")});
    add(result, {"roll_stiffness_cubic_nmprad3", roll.stiffness_cubic_nmprad3.value,
                 fitted(roll.stiffness_cubic_nmprad3, "{:.2g}")});
    add(result, {"roll_stiffness_quintic_nmprad5", roll.stiffness_quintic_nmprad5.value,
                 fitted(roll.stiffness_quintic_nmprad5, "{:.2g}")});
}

void add_steering(Identification& result) {
    const VehicleData& vehicle = result.vehicle;
    if (result.steering) {
        const SteeringFit& steering = *result.steering;
        add(result, {"steering_ratio", steering.ratio.value,
                     steering.ratio_fitted ? fitted(steering.ratio, "{:.2f}") : vehicle_data_origin});
        add(result, {"understeer_gradient_s2pm", steering.understeer_gradient_s2pm.value,
                     steering.gradient_fitted           ? fitted(steering.understeer_gradient_s2pm, "{:.5f}")
                     : vehicle.understeer_gradient_s2pm ? vehicle_data_origin
                                                        : "ASSUMED: one speed tells only one of both"});
    } else {
        add(result, {"steering_ratio", vehicle.steering_ratio.value_or(17.0),
                     vehicle.steering_ratio ? vehicle_data_origin : "ASSUMED"});
        add(result, {"understeer_gradient_s2pm",
                     vehicle.understeer_gradient_s2pm.value_or(usual_understeer_gradient_s2pm),
                     vehicle.understeer_gradient_s2pm ? vehicle_data_origin : "ASSUMED"});
    }
    result.tyres = tyre_limit(vehicle, result.ramps, result.dynamics);
    add(result, {"largest_lateral_acceleration_mps2", result.tyres.largest_mps2, result.tyres.origin});
}

// How the lateral force follows the steering, by the model of the values so far.
void add_response(Identification& result) {
    if (result.steering_is_known()) {
        result.response =
            fit_response(SteeringModel{result.vehicle.wheelbase_m, result.value("steering_ratio"),
                                       result.value("understeer_gradient_s2pm"),
                                       result.value("largest_lateral_acceleration_mps2"),
                                       calibration_default("prediction_filter_lag_s")},
                         result.ramps, result.dynamics);
    }
    if (result.response && result.response->helps()) {
        const ResponseFit& response = *result.response;
        add(result, {"lateral_response_frequency_radps", response.frequency_radps,
                     fmt::format("fitted, within a factor of {:.2f}", response.frequency_factor)});
        add(result, {"lateral_response_damping", response.damping,
                     fmt::format("fitted, within a factor of {:.2f}", response.damping_factor)});
    } else {
        add(result, {"lateral_response_frequency_radps", 0.0, "not known: the drives do not show it"});
        add(result, {"lateral_response_damping", calibration_default("lateral_response_damping"),
                     "without meaning as long as the frequency is not known"});
    }
}

// The stiffness curve and the arm of the calibration.
RollFit written_curve(const Identification& result) {
    RollFit roll = result.roll;
    roll.arm_m = result.value("sprung_cg_height_m") - result.value("fixed_roll_centre_height_m");
    roll.stiffness_nmprad.value = result.value("roll_stiffness_nmprad");
    roll.stiffness_cubic_nmprad3.value = result.value("roll_stiffness_cubic_nmprad3");
    roll.stiffness_quintic_nmprad5.value = result.value("roll_stiffness_quintic_nmprad5");
    return roll;
}

// Angle at which the printed threshold is reached in a slow turn: A/N = T on the fitted curve.
void add_rollover_index(Identification& result) {
    VehicleData vehicle = result.vehicle;
    vehicle.sprung_cg_height_m = result.value("sprung_cg_height_m");
    const RollFit roll = written_curve(result);
    const double angle = rollover_angle_rad(vehicle, roll);
    const double acceleration = acceleration_at_threshold_mps2(roll_lengths(vehicle, roll), angle);
    add(result, {"rollover_index_roll_angle_rad", angle, "roll angle at the threshold in a slow turn"});
    add(result, {"rollover_index_acceleration_mps2", acceleration,
                 "lateral acceleration at the threshold in a slow turn"});
}

// Values that are not written stay as in the template: fine, quiet sensors.
void add_sensors(Identification& result) {
    const SensorQuality& sensors = result.sensors;
    for (const auto& [key, value] : {std::pair{"accelerometer_noise_mps2", sensors.accelerometer_noise_mps2},
                                     std::pair{"speed_resolution_mps", sensors.speed_resolution_mps}}) {
        if (value > 0.0) {
            add(result, {key, value, "of the drives"});
        }
    }
}

}  // namespace

bool Identification::steering_is_known() const {
    return steering || (vehicle.steering_ratio && vehicle.understeer_gradient_s2pm);
}

double Identification::value(std::string_view key) const {
    return std::find_if(values.begin(), values.end(),
                        [key](const IdentifiedValue& each) { return each.key == key; })
        ->value;
}

Identification identify(const VehicleData& vehicle, const std::vector<Drive>& ramps,
                        const std::vector<Drive>& dynamics, const IdentificationOptions& options) {
    if (ramps.empty() || dynamics.empty()) {
        throw IdentificationError(
            "a slow ramp and a dynamic drive are both needed: the one gives the stiffness, the other "
            "damping and inertia");
    }
    Identification result;
    result.vehicle = vehicle;
    result.ramps = prepare_all(ramps, vehicle, options.preparation);
    result.dynamics = prepare_all(dynamics, vehicle, options.preparation);
    choose_roll_centre(result, options.keep_cg_height);
    fit_body(result, usual_arm_m(vehicle));
    result.steering = fit_steering(vehicle, result.ramps);
    add_vehicle(result);
    add_roll(result);
    add_steering(result);
    add_response(result);
    add_rollover_index(result);
    result.sensors = sensor_quality(ramps, dynamics);
    add_sensors(result);
    result.warnings = identification_warnings(result);
    return result;
}

}  // namespace sil
