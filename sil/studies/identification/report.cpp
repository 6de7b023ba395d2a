#include "sil/studies/identification/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sil/files/csv_writer.hpp"
#include "sil/studies/identification/roll_prediction.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

std::string line(const char* name, const Estimate& estimate, double unit, const char* unit_name, int digits) {
    return fmt::format("  {:<34} {:>10.{}f} +-{:<9.{}f} {}\n", name, estimate.value / unit, digits,
                       estimate.deviation / unit, digits, unit_name);
}

std::string drives_text(const std::vector<PreparedDrive>& drives, const char* kind) {
    std::string text;
    for (const PreparedDrive& drive : drives) {
        text += fmt::format("  {} {}: {:.2f} to {:.2f} s, up to {:.2f} g and {:.2f} deg", kind, drive.name,
                            drive.samples.front().time_s, drive.samples.back().time_s,
                            drive.largest_parallel_mps2 / g_mps2,
                            drive.largest_roll_angle_rad * degrees_per_radian);
        if (drive.cut_s) {
            text += fmt::format("; nothing after {:.2f} s: {}", *drive.cut_s, drive.cut_reason);
        }
        const SensorOffsets& offsets = drive.offsets;
        if (offsets.known) {
            text += fmt::format(
                "\n    offsets on the straight ({:.1f} s): {:+.4f} g, roll {:+.3f} deg, {:+.3f} deg/s",
                offsets.straight_s, offsets.lateral_mps2 / g_mps2,
                offsets.roll_angle_rad * degrees_per_radian, offsets.roll_rate_radps * degrees_per_radian);
        }
        text += "\n";
    }
    return text;
}

std::string residuals_text(const std::vector<DriveResidual>& drives) {
    std::string text;
    for (const DriveResidual& drive : drives) {
        text += fmt::format("  {}: R2 {:.4f}, residual {:.0f} N m rms, offset {:+.0f} N m\n", drive.name,
                            drive.r_squared, drive.rms, drive.offset);
    }
    return text;
}

double number_or_nan(bool known, double value) {
    return known ? value : std::nan("");
}

// Linear model of the drives' offsets: the fit's residual is without them.
double fitted_moment(const RollFit& roll, const RollSample& sample, bool dynamic, double offset) {
    return roll.moment_nm(sample.roll_angle_rad) + roll.damping_nmsprad.value * sample.roll_rate_radps +
           roll.inertia_kgm2.value * sample.roll_acceleration_radps2 + offset +
           (dynamic ? roll.dynamic_stiffness_difference_nmprad.value * sample.roll_angle_rad : 0.0);
}

double asked_acceleration(const Identification& result, const RollSample& sample) {
    if (!result.steering) {
        return std::nan("");
    }
    const double square = sample.speed_mps * sample.speed_mps;
    return square * sample.steering_wheel_angle_rad / result.steering->ratio.value /
           (result.vehicle.wheelbase_m + result.steering->understeer_gradient_s2pm.value * square);
}

// With the values of the calibration.
std::vector<double> fitted_response(const Identification& result, const std::vector<RollSample>& samples) {
    if (!result.response || !result.response->helps()) {
        return std::vector<double>(samples.size(), std::nan(""));
    }
    const SteeringModel model{result.vehicle.wheelbase_m, result.value("steering_ratio"),
                              result.value("understeer_gradient_s2pm"),
                              result.value("largest_lateral_acceleration_mps2"), 0.0};
    return response_mps2(model, result.response->frequency_radps, result.response->damping, samples);
}

}  // namespace

std::string identification_report(const Identification& result) {
    const RollFit& roll = result.roll;
    std::string text = fmt::format("Vehicle: {}\n\nDrives\n", result.vehicle.name);
    text += drives_text(result.ramps, "ramp   ") + drives_text(result.dynamics, "dynamic");
    text += fmt::format(
        "\nBody: m_s H f = M(phi) + c phi' + Ixx phi'', M(phi) = K_f phi + K_2 phi^3 + K_4 phi^5\n"
        "  H = {:.3f} m, h_rc = {:.3f} m ({})\n",
        roll.arm_m, result.roll_centre_height_m, result.roll_centre_origin);
    text += line("stiffness K_f", roll.stiffness_nmprad, 1000.0, "kN m/rad", 2);
    text += line("cubic K_2", roll.stiffness_cubic_nmprad3, 1000.0, "kN m/rad^3", 1);
    text += line("quintic K_4", roll.stiffness_quintic_nmprad5, 1.0e6, "MN m/rad^5", 2);
    text += line("damping c", roll.damping_nmsprad, 1000.0, "kN m s/rad", 3);
    text += line("inertia Ixx", roll.inertia_kgm2, 1.0, "kg m^2", 0);
    text += line("dynamic drives stiffer by", roll.dynamic_stiffness_difference_nmprad, 1000.0,
                 "kN m/rad (not in the calibration)", 2);
    if (roll.needed_up_to_rad > roll.data_end_rad) {
        text += fmt::format(
            "  the curve is known up to {:.2f} deg and extrapolated to {:.2f} deg, where its slope is {:.2f} "
            "times that at the end of the data\n",
            roll.data_end_rad * degrees_per_radian, roll.needed_up_to_rad * degrees_per_radian,
            roll.slope_nmprad(roll.needed_up_to_rad) / roll.slope_nmprad(roll.data_end_rad));
    }
    text += fmt::format("  condition number {:.0f}\n", roll.condition_number) + residuals_text(roll.drives);
    if (!result.loads) {
        text += "  Only K/H, c/H and Ixx/H are known from these drives; wheel loads would give H.\n";
    } else {
        const LoadFit& loads = *result.loads;
        text += fmt::format(
            "\nWheel loads in the ramp: effective h_rc {:.3f} +-{:.3f} m (for a CG height known to 1 %); "
            "without the tyres' roll, as (24) counts it, about {:.2f} m\n",
            shown_height_m(loads.roll_centre_at_given_height_m), loads.deviation_m,
            shown_height_m(loads.suspension_roll_centre_m));
        text += "Load transfer ratio as the component computes it, against that of the wheels\n";
        for (const DriveResidual& drive : result.load_transfer) {
            text += fmt::format("  {}: R2 {:.4f}, error {:.4f} rms, {:+.4f} mean\n", drive.name,
                                drive.r_squared, drive.rms, drive.offset);
        }
    }
    if (result.steering) {
        const SteeringFit& steering = *result.steering;
        text += fmt::format("\nSteering: V r = V^2 delta / (L + K_us V^2), up to {:.2f} g\n",
                            steering.largest_used_mps2 / g_mps2);
        text += line("ratio", steering.ratio, 1.0, steering.ratio_fitted ? "(fitted)" : "(given)", 2);
        text += line("K_us", steering.understeer_gradient_s2pm, 1.0,
                     steering.gradient_fitted ? "s^2/m (fitted)" : "s^2/m (given or assumed)", 5);
        text += fmt::format(
            "  R2 {:.4f}, residual {:.3f} deg at the front wheels; fitted beside it and not used: {:+.2f} s "
            "times the steering's rate\n",
            steering.r_squared, steering.rms_rad * degrees_per_radian, steering.lag_s);
    }
    text += fmt::format("\nLimit of the tyres: {:.2f} g, {}\n", result.tyres.largest_mps2 / g_mps2,
                        result.tyres.origin);
    if (result.response) {
        const ResponseFit& response = *result.response;
        text += fmt::format(
            "\nLateral response: A'' = w^2 (a_d - A) - 2 zeta w A', a_d from the steering\n"
            "  w {:.2f} rad/s, within a factor of {:.2f}; zeta {:.2f}, within a factor of {:.2f}\n"
            "  forecast of {:.1f} s: {:.3f} m/s^2 rms; along the trend {:.3f} m/s^2\n",
            response.frequency_radps, response.frequency_factor, response.damping, response.damping_factor,
            response_horizon_s, response.rms_mps2, response.trend_rms_mps2);
    }
    text += result.warnings.empty() ? "\nNothing to warn of.\n" : "\nWarnings\n";
    for (const std::string& warning : result.warnings) {
        text += "  - " + warning + "\n";
    }
    return text;
}

std::vector<FittedDrive> fitted_drives(const Identification& result) {
    std::vector<FittedDrive> fitted;
    const RollModel model = roll_model(result.vehicle, result.roll);
    for (const auto* drives : {&result.ramps, &result.dynamics}) {
        const bool dynamic = drives == &result.dynamics;
        for (const PreparedDrive& drive : *drives) {
            const double offset = result.roll.drives[fitted.size()].offset;
            const std::vector<double> angles = predicted_roll_angles_rad(model, drive.samples);
            const std::vector<double> responses = fitted_response(result, drive.samples);
            FittedDrive one{&drive, dynamic, {}};
            for (std::size_t place = 0U; place < drive.samples.size(); ++place) {
                const RollSample& sample = drive.samples[place];
                FittedSample values;
                values.moment_nm =
                    result.vehicle.sprung_mass_kg * result.roll.arm_m * sample.overturning_mps2;
                values.fitted_moment_nm = fitted_moment(result.roll, sample, dynamic, offset);
                values.static_moment_nm = values.moment_nm - (values.fitted_moment_nm -
                                                              result.roll.moment_nm(sample.roll_angle_rad));
                values.fitted_load_moment_nm = number_or_nan(
                    drive.has_wheel_loads, component_load_moment_nm(result.vehicle, result.roll, sample));
                values.yaw_acceleration_mps2 = sample.yaw_rate_radps * sample.speed_mps;
                values.steering_acceleration_mps2 = asked_acceleration(result, sample);
                values.predicted_roll_angle_rad = angles[place];
                values.response_mps2 = responses[place];
                one.fitted.push_back(values);
            }
            fitted.push_back(one);
        }
    }
    return fitted;
}

std::string fit_csv(const Identification& result) {
    std::string text =
        "running_time_s,drive,dynamic,time_s,roll_angle_deg,road_parallel_force_mps2,moment_nm,"
        "fitted_moment_nm,residual_nm,static_moment_nm,load_moment_nm,fitted_load_moment_nm,"
        "yaw_acceleration_mps2,steering_acceleration_mps2,predicted_roll_angle_deg,"
        "response_acceleration_mps2\n";
    double start_s = 0.0;
    std::size_t number = 0U;
    for (const FittedDrive& drive : fitted_drives(result)) {
        ++number;
        const std::vector<RollSample>& samples = drive.drive->samples;
        const double first_s = samples.front().time_s;
        for (std::size_t place = 0U; place < samples.size(); ++place) {
            const RollSample& sample = samples[place];
            const FittedSample& fitted = drive.fitted[place];
            CsvRow row;
            row.number(start_s + sample.time_s - first_s, 7).count(number).count(drive.dynamic ? 1U : 0U);
            for (const double value :
                 {sample.time_s, sample.roll_angle_rad * degrees_per_radian, sample.parallel_mps2,
                  fitted.moment_nm, fitted.fitted_moment_nm, fitted.moment_nm - fitted.fitted_moment_nm,
                  fitted.static_moment_nm, sample.load_moment_nm, fitted.fitted_load_moment_nm,
                  fitted.yaw_acceleration_mps2, fitted.steering_acceleration_mps2,
                  fitted.predicted_roll_angle_rad * degrees_per_radian, fitted.response_mps2}) {
                row.number(value, 7);
            }
            text += row.line() + "\n";
        }
        start_s += samples.back().time_s - first_s;
    }
    return text;
}

std::vector<StiffnessPoint> stiffness_curve(const Identification& result) {
    const double limit_rad = 1.2 * rollover_angle_rad(result.vehicle, result.roll);
    std::vector<StiffnessPoint> curve;
    for (int k = -100; k <= 100; ++k) {
        const double phi = 0.01 * k * limit_rad;
        curve.push_back({phi, result.roll.moment_nm(phi), result.roll.stiffness_nmprad.value * phi});
    }
    return curve;
}

std::string curve_csv(const Identification& result) {
    std::string text = "roll_angle_deg,moment_nm,linear_moment_nm\n";
    for (const StiffnessPoint& point : stiffness_curve(result)) {
        text += CsvRow{}
                    .number(point.roll_angle_rad * degrees_per_radian, 5)
                    .number(point.moment_nm, 6)
                    .number(point.linear_moment_nm, 6)
                    .line() +
                "\n";
    }
    return text;
}

std::string fit_marks(const Identification& result) {
    double reach = 0.0;
    std::string borders;
    double start_s = 0.0;
    for (const auto* drives : {&result.ramps, &result.dynamics}) {
        for (const PreparedDrive& drive : *drives) {
            if (drives == &result.ramps) {
                reach = std::max(reach, drive.largest_roll_angle_rad);
            }
            borders += fmt::format("{}{:.4g}", borders.empty() ? "" : " ", start_s);
            start_s += drive.samples.back().time_s - drive.samples.front().time_s;
        }
    }
    const bool loads = result.loads.has_value();
    return fmt::format(
        "reach_deg = {:.4g}\ndrive_starts = \"{}\"\nend_s = {:.5g}\nhas_loads = {}\nhas_steering = {}\n",
        reach * degrees_per_radian, borders, start_s, loads ? 1 : 0, result.steering ? 1 : 0);
}

}  // namespace sil
