#include "sil/studies/identification/roll_problem.hpp"

#include <algorithm>
#include <cmath>

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
constexpr double inertia_prior_share = 0.4;
constexpr double known_inertia_share = 0.05;
constexpr double held_inertia_share = 1.0e-4;
constexpr double dynamic_stiffness_share = 0.05;
constexpr double offset_after_straight_g = 0.01;
constexpr double offset_otherwise_g = 0.06;
constexpr int reweightings = 4;

enum Unknown : Eigen::Index { k_f, k_2, k_4, c, ixx, dk, first_offset };

}  // namespace

RollProblem::RollProblem(const VehicleData& vehicle, double arm_m, const std::vector<PreparedDrive>& ramps,
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

RollFit RollProblem::solve(const CurveShape& curve) {
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

double RollProblem::rough_stiffness() const {
    double xy = 0.0, xx = 0.0;
    for (const Member& member : drives_) {
        for (const RollSample& sample : member.drive->samples) {
            xy += sample.roll_angle_rad * mass_arm_kgm_ * sample.overturning_mps2;
            xx += sample.roll_angle_rad * sample.roll_angle_rad;
        }
    }
    return xy / xx;
}

double RollProblem::moment_rms(const PreparedDrive& drive) const {
    double sum = 0.0;
    for (const RollSample& sample : drive.samples) {
        sum += sample.overturning_mps2 * sample.overturning_mps2;
    }
    return mass_arm_kgm_ * std::sqrt(sum / static_cast<double>(drive.samples.size()));
}

std::vector<Prior> RollProblem::priors(double freedom) const {
    const double k = rough_stiffness_nmprad_;
    const double square = curve_reference_rad * curve_reference_rad;
    const double inertia = vehicle_.roll_inertia_kgm2.value_or(usual_roll_inertia_kgm2(vehicle_));
    const double inertia_share = inertia_held_                ? held_inertia_share
                                 : vehicle_.roll_inertia_kgm2 ? known_inertia_share
                                                              : inertia_prior_share;
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
        const double offset_g = member.drive->offsets.known ? offset_after_straight_g : offset_otherwise_g;
        priors.push_back({0.0, offset_g * g_mps2 * mass_arm_kgm_});
    }
    return priors;
}

Eigen::VectorXd RollProblem::psi(std::size_t drive, const RollSample& sample) const {
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

LinearFit RollProblem::solve_once(const std::vector<double>& deviation_nm) const {
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
void RollProblem::hold_slope(LinearProblem& problem) const {
    constexpr int count = 5;
    const double end = curve_.data_end_rad * curve_.data_end_rad;
    for (int k = 1; k <= count; ++k) {
        const double angle = curve_.data_end_rad + k * (curve_.limit_rad - curve_.data_end_rad) / count;
        const double square = angle * angle;
        Eigen::VectorXd psi = Eigen::VectorXd::Zero(first_offset + static_cast<Eigen::Index>(drives_.size()));
        psi[k_2] = 3.0 * (square - end);
        psi[k_4] = 5.0 * (square * square - end * end);
        problem.add(psi, 0.0, rough_stiffness_nmprad_, curve_.hold);
    }
}

DriveResidual RollProblem::residual(std::size_t drive, const LinearFit& linear) const {
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

RollFit RollProblem::result(const LinearFit& linear) const {
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

}  // namespace sil
