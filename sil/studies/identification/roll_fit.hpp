// Roll fit: stiffness curve, damping and inertia of the body's roll from slow and dynamic drives.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sil/slow_turn.hpp"
#include "sil/studies/identification/prepared_drive.hpp"

namespace sil {

struct Estimate {
    double value{};
    double deviation{};        // standard error
    double prior_deviation{};  // deviation by the rule of thumb alone; 0: none was used
};

// One drive's share in a fit.
struct DriveResidual {
    std::string name;
    double rms{};
    double r_squared{};
    double offset{};  // constant part that the fit took up
};

// m_s H f = M(phi) + c phi' + Ixx phi'', M(phi) = K_f phi + K_2 phi^3 + K_4 phi^5, with the H it was given.
struct RollFit {
    double arm_m{};  // H = h - h_rc
    Estimate stiffness_nmprad;
    Estimate stiffness_cubic_nmprad3;
    Estimate stiffness_quintic_nmprad5;
    Estimate damping_nmsprad;
    Estimate inertia_kgm2;
    Estimate dynamic_stiffness_difference_nmprad;  // by which the dynamic drives are stiffer than the ramps
    double condition_number{};
    std::vector<DriveResidual> drives;  // ramps first; in N m
    double data_end_rad{};              // the largest roll angle of the drives; the curve beyond is a guess
    double needed_up_to_rad{};          // by the component: a little beyond the lift of the inner wheels
    // The best fit, if no body has so little; then the data sheet's or the rule of thumb is taken.
    std::optional<double> refused_inertia_kgm2;
    bool curve_flattened{false};   // the curve had to be held back to rise up to rollover
    bool curve_held{false};        // its slope beyond the data had to be
    double largest_slope_share{};  // beyond the data, of the slope at their end; one over it is the least
    bool curve_limited{false};     // its coefficients had to be, to CurveLimits

    double moment_nm(double roll_angle_rad) const;
    double slope_nmprad(double roll_angle_rad) const;
    // The same drives with another H: only the ratios to H are determined by them.
    RollFit with_arm(double arm_m) const;
};

// How large K_2 and K_4 may be, either way.
struct CurveLimits {
    double cubic_nmprad3{std::numeric_limits<double>::infinity()};
    double quintic_nmprad5{std::numeric_limits<double>::infinity()};

    bool admit(const RollFit& fit) const;
};

// H = h - h_rc in metres.
struct RollArm {
    double usual;  // the rules of thumb, which are of absolute size, take this one
    double
        used;  // the fit, its limits and the angle up to which the curve must be plausible are for this one
};

// `ramps` must not be empty; without `dynamics` only the stiffness is more than a rule of thumb. Throws
// IdentificationError when nothing is excited.
RollFit fit_roll(const VehicleData& vehicle, const RollArm& arm, const std::vector<PreparedDrive>& ramps,
                 const std::vector<PreparedDrive>& dynamics, const CurveLimits& limits = {});

// The rule of thumb for Ixx of the sprung mass: radius of gyration 0.42 c_w.
double usual_roll_inertia_kgm2(const VehicleData& vehicle);

RollLengths roll_lengths(const VehicleData& vehicle, const RollFit& fit);

// Roll angle at which the inner wheels have lost their load in a slow turn, (28) with the curve.
double rollover_angle_rad(const VehicleData& vehicle, const RollFit& fit);

}  // namespace sil
