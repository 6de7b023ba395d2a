#include "sil/studies/identification/roll_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sil/studies/identification/bisection.hpp"
#include "sil/studies/identification/prepared_drive.hpp"
#include "sil/studies/identification/roll_problem.hpp"
#include "sil/studies/identification/zero_phase_filter.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

// A body leans out of the turn: with roll angle and lateral acceleration in ISO 8855 signs both grow
// together.
void refuse_wrong_roll_sign(const PreparedDrive& drive) {
    double common = 0.0;
    for (const RollSample& sample : drive.samples) {
        common += sample.roll_angle_rad * sample.overturning_mps2;
    }
    if (common <= 0.0) {
        throw IdentificationError(
            fmt::format("{}: the body leans into the turn. Check the signs: in a left turn lateral "
                        "acceleration, yaw rate and roll angle are positive",
                        drive.name));
    }
}

// The roll rate must be the roll angle's derivative: not so with a wrong sign or a wrong unit.
void refuse_wrong_roll_rate(const PreparedDrive& drive) {
    std::vector<double> angle;
    for (const RollSample& sample : drive.samples) {
        angle.push_back(sample.roll_angle_rad);
    }
    const std::vector<double> slope = differentiate(angle, sample_time_s);
    double common = 0.0, squares = 0.0;
    for (std::size_t k = 0U; k < slope.size(); ++k) {
        common += slope[k] * drive.samples[k].roll_rate_radps;
        squares += drive.samples[k].roll_rate_radps * drive.samples[k].roll_rate_radps;
    }
    const double ratio = common / squares;
    if (ratio < 0.5 || ratio > 2.0) {
        throw IdentificationError(
            fmt::format("{}: the roll angle changes {:.2g} times as fast as the roll rate says. Check "
                        "sign and unit of both columns, that they are of one clock, and that the road is "
                        "level: a bank that changes turns the body and leaves an angle against the road",
                        drive.name, ratio));
    }
}

// Throws IdentificationError with the drive and what to do.
void refuse_without_excitation(const std::vector<PreparedDrive>& ramps,
                               const std::vector<PreparedDrive>& dynamics) {
    for (const PreparedDrive& drive : ramps) {
        if (drive.largest_parallel_mps2 < 0.1 * g_mps2 || drive.largest_roll_angle_rad < 0.002) {
            throw IdentificationError(
                fmt::format("{}: the ramp reaches only {:.2f} g and {:.2f} deg of roll before it ends or "
                            "is cut; nothing can be fitted below 0.1 g. Steer slowly on, to 0.5 g at least",
                            drive.name, drive.largest_parallel_mps2 / g_mps2,
                            drive.largest_roll_angle_rad * degrees_per_radian));
        }
    }
    for (const PreparedDrive& drive : ramps) {
        refuse_wrong_roll_sign(drive);
    }
    for (const PreparedDrive& drive : dynamics) {
        double largest_rate = 0.0;
        for (const RollSample& sample : drive.samples) {
            largest_rate = std::max(largest_rate, std::abs(sample.roll_rate_radps));
        }
        if (largest_rate * degrees_per_radian < 2.0) {
            throw IdentificationError(
                fmt::format("{}: the body rolls with {:.1f} deg/s at most; damping and inertia do not "
                            "show below 2 deg/s. Drive a step steer or a lane change that reaches 0.3 g; "
                            "if it was one, check the units",
                            drive.name, largest_rate * degrees_per_radian));
        }
        refuse_wrong_roll_sign(drive);
        refuse_wrong_roll_rate(drive);
    }
}

constexpr double usual_gyration_share = 0.42;  // of the track width
// Share of the rule of thumb, or of the data sheet's Ixx. A body has more, on soft tyres too: with less its
// mass would lie within a fifth of the track width about its middle. Then something else follows the roll
// acceleration, such as a frame that twists, and takes its place in the fit.
constexpr double impossible_inertia_share = 0.2;
// Stops and bump rubbers stiffen a suspension; none grows soft.
constexpr double least_slope_share = 0.5;
constexpr double beyond_rollover = 1.5;
// If no drive shows the curve, its slope stays within these shares, and one over them, of the one at the end
// of the data: nearly straight as springs go on, and less so only if that would change the curve within the
// data, as it does where they show a stop. This holds up to the largest angle at which the component still
// needs the curve, a little beyond the lift of the inner wheels, so far as a prediction looks. Without a stop
// it holds at least as far beyond the data as a fast turn swings further than the slow one. Further on every
// answer is "warn".
constexpr double beyond_lift = 1.2;
constexpr double beyond_data = 1.5;
constexpr std::array<double, 2> straight_slope_shares{1.5, 1.75};
constexpr double largest_slope_beyond_data = 2.0;
constexpr double largest_change_within_data = 0.01;

bool rises_up_to(const RollFit& fit, double limit_rad) {
    for (int k = 0; k <= 100; ++k) {
        if (fit.slope_nmprad(0.01 * k * limit_rad) < least_slope_share * fit.stiffness_nmprad.value) {
            return false;
        }
    }
    return true;
}

bool stays_plausible(const RollFit& fit, double limit_rad, double largest_share) {
    const double at_end = fit.slope_nmprad(fit.data_end_rad);
    for (int k = 1; k <= 100 && limit_rad > fit.data_end_rad; ++k) {
        const double angle = fit.data_end_rad + 0.01 * k * (limit_rad - fit.data_end_rad);
        const double share = fit.slope_nmprad(angle) / at_end;
        if (share * largest_share < 1.0 || share > largest_share) {
            return false;
        }
    }
    return true;
}

double largest_angle_rad(const std::vector<PreparedDrive>& ramps,
                         const std::vector<PreparedDrive>& dynamics) {
    double largest = 0.0;
    for (const auto* drives : {&ramps, &dynamics}) {
        for (const PreparedDrive& drive : *drives) {
            largest = std::max(largest, drive.largest_roll_angle_rad);
        }
    }
    return largest;
}

bool agree_within_data(const RollFit& fit, const RollFit& reference) {
    for (int k = 1; k <= 20; ++k) {
        const double angle = 0.05 * k * reference.data_end_rad;
        const double moment_nm = reference.moment_nm(angle);
        if (std::abs(fit.moment_nm(angle) - moment_nm) > largest_change_within_data * moment_nm) {
            return false;
        }
    }
    return true;
}

// Fits of one problem under different constraints of the curve.
struct CurveFit {
    const VehicleData& vehicle;
    double arm_m;
    const CurveLimits& limits;
    RollProblem& problem;

    RollFit solve(const CurveShape& curve) const {
        RollFit fit = problem.solve(curve).with_arm(arm_m);
        fit.data_end_rad = curve.data_end_rad;
        return fit;
    }

    // Up to here the slope may be at most `largest_share` times that at the end of the data.
    double furthest_rad(const RollFit& fit, double largest_share) const {
        const double needed_rad = beyond_lift * rollover_angle_rad(vehicle, fit);
        return largest_share < largest_slope_beyond_data
                   ? std::max(needed_rad, beyond_data * fit.data_end_rad)
                   : needed_rad;
    }

    bool goes_on_straight(const RollFit& fit, double largest_share) const {
        return stays_plausible(fit, furthest_rad(fit, largest_share), largest_share);
    }

    bool rises(const RollFit& fit) const {
        return rises_up_to(fit, beyond_rollover * rollover_angle_rad(vehicle, fit));
    }

    // `fit` is the solution with `curve`.
    RollFit shaped(RollFit fit, CurveShape curve, double largest_share) const {
        bool flattened = false, held = false, limited = false;
        for (int pass = 0; pass < 30; ++pass) {
            curve.limit_rad = furthest_rad(fit, largest_share);
            if (!rises(fit)) {
                flattened = true;
                curve.freedom *= 0.6;
            } else if (!stays_plausible(fit, curve.limit_rad, largest_share)) {
                held = true;
                curve.hold = curve.hold > 0.0 ? 3.0 * curve.hold : 1.0;
            } else if (!limits.admit(fit)) {
                limited = true;
                curve.freedom *= 0.6;
            } else {
                break;
            }
            fit = solve(curve);
        }
        fit.curve_flattened = flattened;
        fit.curve_held = held;
        fit.curve_limited = limited;
        fit.largest_slope_share = largest_share;
        return fit;
    }

    // As straight beyond the data as the curve within them allows. A falling quintic term lets a curve that
    // rises within the data go on straight: `free` is the solution with `curve`, which has one.
    RollFit straightened(const RollFit& fit, const RollFit& free, const CurveShape& curve) const {
        for (const double share : straight_slope_shares) {
            RollFit straighter = fit;
            if (!goes_on_straight(fit, share)) {
                straighter = shaped(free, curve, share);
                straighter.curve_held = fit.curve_held;
            }
            if (rises(straighter) && goes_on_straight(straighter, share) && limits.admit(straighter) &&
                agree_within_data(straighter, fit)) {
                straighter.largest_slope_share = share;
                return straighter;
            }
        }
        return fit;
    }
};

Estimate scaled(const Estimate& estimate, double factor) {
    return {estimate.value * factor, estimate.deviation * factor, estimate.prior_deviation * factor};
}

}  // namespace

double RollFit::moment_nm(double phi) const {
    const double square = phi * phi;
    return phi * (stiffness_nmprad.value +
                  square * (stiffness_cubic_nmprad3.value + square * stiffness_quintic_nmprad5.value));
}

double RollFit::slope_nmprad(double phi) const {
    const double square = phi * phi;
    return stiffness_nmprad.value +
           square * (3.0 * stiffness_cubic_nmprad3.value + 5.0 * square * stiffness_quintic_nmprad5.value);
}

RollFit RollFit::with_arm(double new_arm_m) const {
    const double factor = new_arm_m / arm_m;
    RollFit fit = *this;
    fit.arm_m = new_arm_m;
    for (Estimate* estimate :
         {&fit.stiffness_nmprad, &fit.stiffness_cubic_nmprad3, &fit.stiffness_quintic_nmprad5,
          &fit.damping_nmsprad, &fit.inertia_kgm2, &fit.dynamic_stiffness_difference_nmprad}) {
        *estimate = scaled(*estimate, factor);
    }
    for (DriveResidual& drive : fit.drives) {
        drive.rms *= factor;
        drive.offset *= factor;
    }
    return fit;
}

bool CurveLimits::admit(const RollFit& fit) const {
    return std::abs(fit.stiffness_cubic_nmprad3.value) <= cubic_nmprad3 &&
           std::abs(fit.stiffness_quintic_nmprad5.value) <= quintic_nmprad5;
}

RollFit fit_roll(const VehicleData& vehicle, const RollArm& arm, const std::vector<PreparedDrive>& ramps,
                 const std::vector<PreparedDrive>& dynamics, const CurveLimits& limits) {
    refuse_without_excitation(ramps, dynamics);
    RollProblem problem{vehicle, arm.usual, ramps, dynamics};
    CurveShape curve;
    curve.data_end_rad = largest_angle_rad(ramps, dynamics);
    const CurveFit curve_fit{vehicle, arm.used, limits, problem};
    RollFit free = curve_fit.solve(curve);
    const double usual_kgm2 = vehicle.roll_inertia_kgm2.value_or(usual_roll_inertia_kgm2(vehicle));
    std::optional<double> refused_kgm2;
    if (free.inertia_kgm2.value < impossible_inertia_share * usual_kgm2) {
        refused_kgm2 = free.inertia_kgm2.value;
        problem.hold_inertia();
        free = curve_fit.solve(curve);
    }
    CurveShape rising = curve;
    rising.quintic = free.stiffness_quintic_nmprad5.value > 0.0;
    RollFit fit =
        curve_fit.shaped(rising.quintic ? free : curve_fit.solve(rising), rising, largest_slope_beyond_data);
    fit = curve_fit.straightened(fit, free, curve);
    fit.refused_inertia_kgm2 = refused_kgm2;
    fit.needed_up_to_rad = beyond_lift * rollover_angle_rad(vehicle, fit);
    return fit;
}

double usual_roll_inertia_kgm2(const VehicleData& vehicle) {
    const double radius_m = usual_gyration_share * vehicle.track_width_m;
    return vehicle.sprung_mass_kg * radius_m * radius_m;
}

RollLengths roll_lengths(const VehicleData& vehicle, const RollFit& fit) {
    return {vehicle.track_width_m, vehicle.sprung_cg_height_m, fit.arm_m};
}

// M(phi) = m_s H g [T(phi) + tan phi]; the left side rises faster.
double rollover_angle_rad(const VehicleData& vehicle, const RollFit& fit) {
    const double weight_moment_nm = vehicle.sprung_mass_kg * fit.arm_m * g_mps2;
    const RollLengths lengths = roll_lengths(vehicle, fit);
    return last_where(
        [&](double phi) {
            return fit.moment_nm(phi) <
                   weight_moment_nm * (threshold_in_slow_turn(lengths, phi) + std::tan(phi));
        },
        0.0, 0.6);
}

}  // namespace sil
