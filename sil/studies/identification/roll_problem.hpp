// Roll problem: the linear least squares behind the roll fit, for one shape of the stiffness curve.
#pragma once

#include <vector>

#include "sil/studies/identification/least_squares.hpp"
#include "sil/studies/identification/prepared_drive.hpp"
#include "sil/studies/identification/roll_fit.hpp"

namespace sil {

// Constraints of the stiffness curve.
struct CurveShape {
    double freedom{1.0};  // scales how far it may bend; 0 is a line
    bool quintic{true};   // otherwise K_4 is zero
    // From where the data end to the second angle the slope shall stay, the more the larger `hold` is.
    double data_end_rad{0.0};
    double limit_rad{0.0};
    double hold{0.0};
};

class RollProblem {
 public:
    // Keeps references to all but the arm.
    RollProblem(const VehicleData& vehicle, double arm_m, const std::vector<PreparedDrive>& ramps,
                const std::vector<PreparedDrive>& dynamics);

    RollFit solve(const CurveShape& curve);

    // From now on Ixx is that of the vehicle data or the rule of thumb, whatever the drives show.
    void hold_inertia() { inertia_held_ = true; }

 private:
    struct Member {
        const PreparedDrive* drive;
        bool dynamic;
    };

    double rough_stiffness() const;
    double moment_rms(const PreparedDrive& drive) const;
    std::vector<Prior> priors(double freedom) const;
    Eigen::VectorXd psi(std::size_t drive, const RollSample& sample) const;
    LinearFit solve_once(const std::vector<double>& deviation_nm) const;
    void hold_slope(LinearProblem& problem) const;
    DriveResidual residual(std::size_t drive, const LinearFit& linear) const;
    RollFit result(const LinearFit& linear) const;

    const VehicleData& vehicle_;
    double mass_arm_kgm_;
    double arm_m_;
    double rough_stiffness_nmprad_{};
    bool inertia_held_{false};
    CurveShape curve_{};
    std::vector<Member> drives_;
};

}  // namespace sil
