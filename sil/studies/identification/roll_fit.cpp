#include "sil/studies/identification/roll_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sil/studies/identification/least_squares.hpp"
#include "sil/studies/identification/zero_phase_filter.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

// Errors of the model last about so long: one independent observation a fifth of a second.
constexpr double correlation_s = 0.2;
// The model is never trusted beyond this share of a drive's moment, however clean the signals.
constexpr double model_error_share = 0.005;
// Half of the stiffness at this angle may come from the curve.
constexpr double curve_reference_rad = 0.1;
constexpr double curve_share = 0.5;
constexpr double usual_gyration_share = 0.42;  // of the track width
constexpr double inertia_prior_share = 0.4;
constexpr double known_inertia_share = 0.05;
constexpr double dynamic_stiffness_share = 0.05;
constexpr double offset_after_straight_g = 0.01;
constexpr double offset_otherwise_g = 0.06;
// Stops and bump rubbers stiffen a suspension; none grows soft.
constexpr double least_slope_share = 0.5;
constexpr double beyond_rollover = 1.5;
// Where no drive shows the curve, its slope stays within these shares of the one where the data end, up to
// the largest angle at which the component still needs it: a little beyond the lift of the inner wheels, so
// far as a prediction looks. Further on every answer is "warn".
constexpr double beyond_lift = 1.2;
constexpr double least_slope_beyond_data = 0.5;
constexpr double largest_slope_beyond_data = 2.0;
constexpr int reweightings = 4;

enum Unknown : Eigen::Index { k_f, k_2, k_4, c, ixx, dk, first_offset };

// What the stiffness curve may be.
struct Curve {
    double freedom{1.0};  // scales how far it may bend; 0 is a line
    bool quintic{true};   // otherwise K_4 is zero
    // From where the data end to the second angle the slope shall stay, the more the larger `hold` is.
    double data_end_rad{0.0};
    double limit_rad{0.0};
    double hold{0.0};
};

class RollProblem {
 public:
    RollProblem(const VehicleData& vehicle, double arm_m, const std::vector<PreparedDrive>& ramps,
                const std::vector<PreparedDrive>& dynamics)
        : vehicle_{vehicle}, mass_arm_kgm_{vehicle.sprung_mass_kg * arm_m}, arm_m_{arm_m} {
        for (const PreparedDrive& drive : ramps) {
            drives_.push_back({&drive, false});
        }
        for (const PreparedDrive& drive : dynamics) {
            drives_.push_back({&drive, true});
        }
        rough_stiffness_nmprad_ = rough_stiffness();
    }

    RollFit solve(const Curve& curve) {
        curve_ = curve;
        std::vector<double> deviation_nm(drives_.size(), 0.0);
        for (std::size_t i = 0U; i < drives_.size(); ++i) {
            deviation_nm[i] = 0.05 * moment_rms(*drives_[i].drive);
        }
        LinearFit linear;
        for (int pass = 0; pass < reweightings; ++pass) {
            linear = solve_once(deviation_nm);
            for (std::size_t i = 0U; i < drives_.size(); ++i) {
                deviation_nm[i] =
                    std::max(residual(i, linear).rms, model_error_share * moment_rms(*drives_[i].drive));
            }
        }
        return result(linear);
    }

 private:
    struct Member {
        const PreparedDrive* drive;
        bool dynamic;
    };

    double rough_stiffness() const {
        double xy = 0.0, xx = 0.0;
        for (const Member& member : drives_) {
            for (const RollSample& sample : member.drive->samples) {
                xy += sample.roll_angle_rad * mass_arm_kgm_ * sample.overturning_mps2;
                xx += sample.roll_angle_rad * sample.roll_angle_rad;
            }
        }
        return xy / xx;
    }

    double moment_rms(const PreparedDrive& drive) const {
        double sum = 0.0;
        for (const RollSample& sample : drive.samples) {
            sum += sample.overturning_mps2 * sample.overturning_mps2;
        }
        return mass_arm_kgm_ * std::sqrt(sum / static_cast<double>(drive.samples.size()));
    }

    std::vector<Prior> priors(double freedom) const {
        const double k = rough_stiffness_nmprad_;
        const double square = curve_reference_rad * curve_reference_rad;
        const double inertia = vehicle_.roll_inertia_kgm2.value_or(usual_roll_inertia_kgm2(vehicle_));
        const double inertia_share = vehicle_.roll_inertia_kgm2 ? known_inertia_share : inertia_prior_share;
        const double held = std::max(0.3 * k, k - mass_arm_kgm_ * g_mps2);
        const double damping = 2.0 * 0.3 * std::sqrt(held * inertia);
        std::vector<Prior> priors{
            {k, k},
            {0.0, freedom * curve_share * k / square},
            {0.0, (curve_.quintic ? freedom : 1.0e-9) * curve_share * k / (square * square)},
            {damping, damping},
            {inertia, inertia_share * inertia},
            {0.0, dynamic_stiffness_share * k}};
        for (const Member& member : drives_) {
            const double offset_g =
                member.drive->offsets.known ? offset_after_straight_g : offset_otherwise_g;
            priors.push_back({0.0, offset_g * g_mps2 * mass_arm_kgm_});
        }
        return priors;
    }

    Eigen::VectorXd psi(std::size_t drive, const RollSample& sample) const {
        const double phi = sample.roll_angle_rad;
        const double cube = phi * phi * phi;
        Eigen::VectorXd psi = Eigen::VectorXd::Zero(first_offset + static_cast<Eigen::Index>(drives_.size()));
        psi[k_f] = phi;
        psi[k_2] = cube;
        psi[k_4] = cube * phi * phi;
        psi[c] = sample.roll_rate_radps;
        psi[ixx] = sample.roll_acceleration_radps2;
        psi[dk] = drives_[drive].dynamic ? phi : 0.0;
        psi[first_offset + static_cast<Eigen::Index>(drive)] = 1.0;
        return psi;
    }

    LinearFit solve_once(const std::vector<double>& deviation_nm) const {
        LinearProblem problem{priors(curve_.freedom)};
        for (std::size_t i = 0U; i < drives_.size(); ++i) {
            for (const RollSample& sample : drives_[i].drive->samples) {
                problem.add(psi(i, sample), mass_arm_kgm_ * sample.overturning_mps2, deviation_nm[i],
                            sample_time_s / correlation_s);
            }
        }
        if (curve_.hold > 0.0) {
            hold_slope(problem);
        }
        return problem.solve();
    }

    // As if the slope beyond the data had been seen to be that at their end.
    void hold_slope(LinearProblem& problem) const {
        constexpr int count = 5;
        const double end = curve_.data_end_rad * curve_.data_end_rad;
        for (int k = 1; k <= count; ++k) {
            const double angle = curve_.data_end_rad + k * (curve_.limit_rad - curve_.data_end_rad) / count;
            const double square = angle * angle;
            Eigen::VectorXd psi =
                Eigen::VectorXd::Zero(first_offset + static_cast<Eigen::Index>(drives_.size()));
            psi[k_2] = 3.0 * (square - end);
            psi[k_4] = 5.0 * (square * square - end * end);
            problem.add(psi, 0.0, rough_stiffness_nmprad_, curve_.hold);
        }
    }

    DriveResidual residual(std::size_t drive, const LinearFit& linear) const {
        const PreparedDrive& prepared = *drives_[drive].drive;
        double squares = 0.0, sum = 0.0, sum_of_squares = 0.0;
        for (const RollSample& sample : prepared.samples) {
            const double y = mass_arm_kgm_ * sample.overturning_mps2;
            const double error = y - psi(drive, sample).dot(linear.value);
            squares += error * error;
            sum += y;
            sum_of_squares += y * y;
        }
        const double count = static_cast<double>(prepared.samples.size());
        const double variation = sum_of_squares - sum * sum / count;
        return DriveResidual{prepared.name, std::sqrt(squares / count),
                             variation > 0.0 ? 1.0 - squares / variation : 0.0,
                             linear.value[first_offset + static_cast<Eigen::Index>(drive)]};
    }

    RollFit result(const LinearFit& linear) const {
        const std::vector<Prior> prior = priors(1.0);
        const auto estimate = [&](Unknown unknown) {
            return Estimate{linear.value[unknown], linear.deviation[unknown],
                            prior[static_cast<std::size_t>(unknown)].deviation};
        };
        RollFit fit;
        fit.arm_m = arm_m_;
        fit.stiffness_nmprad = estimate(k_f);
        fit.stiffness_cubic_nmprad3 = estimate(k_2);
        fit.stiffness_quintic_nmprad5 = curve_.quintic ? estimate(k_4) : Estimate{};
        fit.damping_nmsprad = estimate(c);
        fit.inertia_kgm2 = estimate(ixx);
        fit.dynamic_stiffness_difference_nmprad = estimate(dk);
        fit.condition_number = linear.condition_number;
        for (std::size_t i = 0U; i < drives_.size(); ++i) {
            fit.drives.push_back(residual(i, linear));
        }
        return fit;
    }

    const VehicleData& vehicle_;
    double mass_arm_kgm_;
    double arm_m_;
    double rough_stiffness_nmprad_{};
    Curve curve_{};
    std::vector<Member> drives_;
};

bool rises_up_to(const RollFit& fit, double limit_rad) {
    for (int k = 0; k <= 100; ++k) {
        if (fit.slope_nmprad(0.01 * k * limit_rad) < least_slope_share * fit.stiffness_nmprad.value) {
            return false;
        }
    }
    return true;
}

bool stays_plausible(const RollFit& fit, double limit_rad) {
    const double at_end = fit.slope_nmprad(fit.data_end_rad);
    for (int k = 1; k <= 100 && limit_rad > fit.data_end_rad; ++k) {
        const double angle = fit.data_end_rad + 0.01 * k * (limit_rad - fit.data_end_rad);
        const double share = fit.slope_nmprad(angle) / at_end;
        if (share < least_slope_beyond_data || share > largest_slope_beyond_data) {
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
                        "acceleration, yaw rate and roll "
                        "angle are positive",
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
            fmt::format("{}: the roll angle changes {:.2g} times as fast as the roll rate says. Check sign "
                        "and unit of both columns, "
                        "and that they are of one clock",
                        drive.name, ratio));
    }
}

void refuse_without_excitation(const std::vector<PreparedDrive>& ramps,
                               const std::vector<PreparedDrive>& dynamics) {
    for (const PreparedDrive& drive : ramps) {
        if (drive.largest_parallel_mps2 < 0.1 * g_mps2 || drive.largest_roll_angle_rad < 0.002) {
            throw IdentificationError(
                fmt::format("{}: the ramp reaches only {:.2f} g and {:.2f} deg of roll before it ends or is "
                            "cut; nothing can be "
                            "fitted below 0.1 g. Steer slowly on, to 0.5 g at least",
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
                fmt::format("{}: the body rolls with {:.1f} deg/s at most; damping and inertia do not show "
                            "below 2 deg/s. Drive a "
                            "step steer or a lane change that reaches 0.3 g; if it was one, check the units",
                            drive.name, largest_rate * degrees_per_radian));
        }
        refuse_wrong_roll_sign(drive);
        refuse_wrong_roll_rate(drive);
    }
}

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
    Curve curve;
    curve.data_end_rad = largest_angle_rad(ramps, dynamics);
    const auto solve = [&] {
        RollFit fit = problem.solve(curve).with_arm(arm.used);
        fit.data_end_rad = curve.data_end_rad;
        return fit;
    };
    RollFit fit = solve();
    curve.quintic = fit.stiffness_quintic_nmprad5.value > 0.0;
    if (!curve.quintic) {
        fit = solve();
    }
    bool flattened = false, held = false, limited = false;
    for (int pass = 0; pass < 30; ++pass) {
        const double lift_rad = rollover_angle_rad(vehicle, fit);
        curve.limit_rad = beyond_lift * lift_rad;
        if (!rises_up_to(fit, beyond_rollover * lift_rad)) {
            flattened = true;
            curve.freedom *= 0.6;
        } else if (!stays_plausible(fit, curve.limit_rad)) {
            held = true;
            curve.hold = curve.hold > 0.0 ? 3.0 * curve.hold : 1.0;
        } else if (!limits.admit(fit)) {
            limited = true;
            curve.freedom *= 0.6;
        } else {
            break;
        }
        fit = solve();
    }
    fit.curve_flattened = flattened;
    fit.curve_held = held;
    fit.curve_limited = limited;
    fit.needed_up_to_rad = beyond_lift * rollover_angle_rad(vehicle, fit);
    return fit;
}

double usual_roll_inertia_kgm2(const VehicleData& vehicle) {
    const double radius_m = usual_gyration_share * vehicle.track_width_m;
    return vehicle.sprung_mass_kg * radius_m * radius_m;
}

// M(phi) = m_s H g [T(phi) + tan phi], T(phi) = (c_w/2 - H tan phi)/h; the left side rises faster.
double rollover_angle_rad(const VehicleData& vehicle, const RollFit& fit) {
    const double weight_moment_nm = vehicle.sprung_mass_kg * fit.arm_m * g_mps2;
    double low = 0.0, high = 0.6;
    for (int k = 0; k < 50; ++k) {
        const double phi = 0.5 * (low + high);
        const double threshold =
            (0.5 * vehicle.track_width_m - fit.arm_m * std::tan(phi)) / vehicle.sprung_cg_height_m;
        (fit.moment_nm(phi) < weight_moment_nm * (threshold + std::tan(phi)) ? low : high) = phi;
    }
    return low;
}

}  // namespace sil
