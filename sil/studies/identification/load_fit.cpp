#include "sil/studies/identification/load_fit.hpp"

#include <algorithm>
#include <cmath>

#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double slow_radps = 0.05;  // faster, and inertia has its part in the loads
constexpr double cg_height_uncertainty = 0.01;
constexpr double lowest_roll_centre_m = 0.0;
constexpr double highest_roll_centre_m = 1.2;
constexpr double highest_roll_centre_share = 0.7;  // of the CG height
// A load that sways moves the CG sideways with the force as a CG would that lies at its pivot or at the
// middle of the tank's curvature: some tenths of a metre higher for a third of the mass. Beyond that a datum
// is wrong.
constexpr double largest_cg_change = 0.15;
// Nearer than what is said of a height, to two decimals, a roll centre is that height.
constexpr double rounding_m = 0.005;
// Tyres carry their load with about this deflection.
constexpr double usual_tyre_deflection_m = 0.02;

double unsprung_moment_kgm(const VehicleData& vehicle) {
    return vehicle.unsprung_mass_kg * vehicle.unsprung_cg_height_m;
}

// Sums for a straight line y = slope x + offset of each drive, with one slope for all.
struct Line {
    double xx{};
    double xy{};

    double slope() const { return xx > 0.0 ? xy / xx : 0.0; }
};

template <typename X, typename Y>
Line regress(const std::vector<PreparedDrive>& drives, const X& x, const Y& y) {
    Line line;
    for (const PreparedDrive& drive : drives) {
        if (!drive.has_wheel_loads) {
            continue;
        }
        double count = 0.0, sum_x = 0.0, sum_y = 0.0, xx = 0.0, xy = 0.0;
        for (const RollSample& sample : drive.samples) {
            if (std::abs(sample.roll_rate_radps) > slow_radps) {
                continue;
            }
            count += 1.0;
            sum_x += x(sample);
            sum_y += y(sample);
            xx += x(sample) * x(sample);
            xy += x(sample) * y(sample);
        }
        // After a straight the loads' offset is already off, and a line with an offset would be worse.
        if (count < 1.0) {
            continue;
        }
        const double offset_known = drive.offsets.known ? 0.0 : 1.0;
        line.xx += xx - offset_known * sum_x * sum_x / count;
        line.xy += xy - offset_known * sum_x * sum_y / count;
    }
    return line;
}

double arm_for(const VehicleData& vehicle, const std::vector<PreparedDrive>& ramps, double cg_height_m) {
    const double tipping_kgm = vehicle.sprung_mass_kg * cg_height_m + unsprung_moment_kgm(vehicle);
    return regress(
               ramps,
               [&](const RollSample& sample) {
                   return vehicle.sprung_mass_kg * (sample.overturning_mps2 - sample.parallel_mps2);
               },
               [&](const RollSample& sample) {
                   return sample.load_moment_nm - tipping_kgm * sample.parallel_mps2;
               })
        .slope();
}

// The tyres let the whole vehicle roll by L / (c_w^2 k) about the road, with the arm h for the body.
double arm_without_tyres(const VehicleData& vehicle, const std::vector<PreparedDrive>& ramps) {
    const double tyre_npm = vehicle.total_mass_kg * g_mps2 / 4.0 / usual_tyre_deflection_m;
    const double axle_nmprad = vehicle.track_width_m * vehicle.track_width_m * tyre_npm;
    const double whole_kgm =
        vehicle.sprung_mass_kg * vehicle.sprung_cg_height_m + unsprung_moment_kgm(vehicle);
    return regress(
               ramps,
               [&](const RollSample& sample) {
                   const double tyres_rad = sample.load_moment_nm / axle_nmprad;
                   return vehicle.sprung_mass_kg * sample.normal_mps2 *
                          std::tan(sample.roll_angle_rad - tyres_rad);
               },
               [&](const RollSample& sample) {
                   const double tyres_rad = sample.load_moment_nm / axle_nmprad;
                   return sample.load_moment_nm -
                          whole_kgm * (sample.parallel_mps2 + sample.normal_mps2 * tyres_rad);
               })
        .slope();
}

double highest_roll_centre(const VehicleData& vehicle) {
    return std::min(highest_roll_centre_m, highest_roll_centre_share * vehicle.sprung_cg_height_m);
}

// h that the loads of the slow turns speak for when the roll centre lies at `roll_centre_m`.
double matched_cg_height_m(const VehicleData& vehicle, const std::vector<PreparedDrive>& ramps,
                           double roll_centre_m) {
    return regress(
               ramps,
               [&](const RollSample& sample) { return vehicle.sprung_mass_kg * sample.overturning_mps2; },
               [&](const RollSample& sample) {
                   return sample.load_moment_nm - unsprung_moment_kgm(vehicle) * sample.parallel_mps2 +
                          roll_centre_m * vehicle.sprung_mass_kg *
                              (sample.overturning_mps2 - sample.parallel_mps2);
               })
        .slope();
}

}  // namespace

std::optional<LoadFit> fit_loads(const VehicleData& vehicle, const std::vector<PreparedDrive>& ramps,
                                 bool keep_cg_height) {
    const bool any = std::any_of(ramps.begin(), ramps.end(),
                                 [](const PreparedDrive& drive) { return drive.has_wheel_loads; });
    if (!any) {
        return std::nullopt;
    }
    const double h = vehicle.sprung_cg_height_m;
    const double arm_m = arm_for(vehicle, ramps, h);
    const double other_arm_m = arm_for(vehicle, ramps, (1.0 + cg_height_uncertainty) * h);
    LoadFit fit;
    fit.roll_centre_at_given_height_m = h - arm_m;
    fit.deviation_m = std::abs(other_arm_m - arm_m - cg_height_uncertainty * h);
    fit.suspension_roll_centre_m = h - arm_without_tyres(vehicle, ramps);
    fit.roll_centre_height_m =
        std::clamp(fit.roll_centre_at_given_height_m, lowest_roll_centre_m, highest_roll_centre(vehicle));
    fit.agreeing_cg_height_m =
        std::abs(fit.roll_centre_height_m - fit.roll_centre_at_given_height_m) <= rounding_m
            ? h
            : matched_cg_height_m(vehicle, ramps, fit.roll_centre_height_m);
    fit.contradicts_data = std::abs(fit.agreeing_cg_height_m / h - 1.0) > largest_cg_change;
    fit.cg_height_m = keep_cg_height || fit.contradicts_data ? h : fit.agreeing_cg_height_m;
    return fit;
}

double component_load_moment_nm(const VehicleData& vehicle, const RollFit& roll, const RollSample& sample) {
    const double alpha_kgm =
        vehicle.sprung_mass_kg * (vehicle.sprung_cg_height_m - roll.arm_m) + unsprung_moment_kgm(vehicle);
    return alpha_kgm * sample.parallel_mps2 + roll.moment_nm(sample.roll_angle_rad) +
           roll.damping_nmsprad.value * sample.roll_rate_radps;
}

std::vector<DriveResidual> load_transfer_residuals(const VehicleData& vehicle, const RollFit& roll,
                                                   const std::vector<PreparedDrive>& drives) {
    std::vector<DriveResidual> residuals;
    for (const PreparedDrive& drive : drives) {
        if (!drive.has_wheel_loads) {
            continue;
        }
        double squares = 0.0, sum = 0.0, sum_of_squares = 0.0, errors = 0.0;
        for (const RollSample& sample : drive.samples) {
            const double scale = 2.0 / (vehicle.total_mass_kg * sample.normal_mps2 * vehicle.track_width_m);
            const double ratio = scale * sample.load_moment_nm;
            const double error = ratio - scale * component_load_moment_nm(vehicle, roll, sample);
            errors += error;
            squares += error * error;
            sum += ratio;
            sum_of_squares += ratio * ratio;
        }
        const double count = static_cast<double>(drive.samples.size());
        const double variation = sum_of_squares - sum * sum / count;
        residuals.push_back(DriveResidual{drive.name, std::sqrt(squares / count),
                                          variation > 0.0 ? 1.0 - squares / variation : 0.0, errors / count});
    }
    return residuals;
}

}  // namespace sil
