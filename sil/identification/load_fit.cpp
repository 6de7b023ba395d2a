#include "sil/identification/load_fit.hpp"

#include <algorithm>
#include <cmath>

#include "sil/identification/least_squares.hpp"

namespace sil {
namespace {

constexpr double independence = 0.05;        // one independent observation a fifth of a second
constexpr double model_error_share = 0.01;   // of the load moment: pitch, the axles' own inertia
constexpr double usual_roll_centre_m = 0.2;  // before anything is known
constexpr double roll_centre_deviation_m = 0.2;
constexpr double cg_height_trust = 0.01;  // of the CG's height
constexpr double cg_height_search = 0.3;

class LoadProblem {
 public:
    LoadProblem(const VehicleData& vehicle, const RollFit& roll, const std::vector<PreparedDrive>& drives)
        : vehicle_{vehicle}, inertia_share_{roll.inertia_kgm2.value / roll.arm_m} {
        for (const PreparedDrive& drive : drives) {
            if (drive.has_wheel_loads) {
                drives_.push_back(&drive);
            }
        }
    }

    bool empty() const { return drives_.empty(); }

    // Unknowns: H, h, an offset a drive.
    LinearFit solve(double cg_height_m, double cg_height_deviation_m) const {
        const double expected_arm = cg_height_m - vehicle_.roll_centre_height_m.value_or(usual_roll_centre_m);
        std::vector<Prior> priors{{expected_arm, roll_centre_deviation_m},
                                  {cg_height_m, cg_height_deviation_m}};
        for (const PreparedDrive* drive : drives_) {
            priors.push_back({0.0, (drive->offsets.known ? 0.01 : 0.1) * vehicle_.total_mass_kg * 9.8});
        }
        LinearProblem problem{priors};
        for (std::size_t i = 0U; i < drives_.size(); ++i) {
            const double deviation_nm = std::max(1.0, model_error_share * load_rms(*drives_[i]));
            for (const RollSample& sample : drives_[i]->samples) {
                problem.add(psi(i, sample), known_removed(sample), deviation_nm, independence);
            }
        }
        return problem.solve();
    }

    DriveResidual residual(std::size_t i, const LinearFit& fit) const {
        double squares = 0.0, sum = 0.0, sum_of_squares = 0.0;
        for (const RollSample& sample : drives_[i]->samples) {
            const double error = known_removed(sample) - psi(i, sample).dot(fit.value);
            squares += error * error;
            sum += sample.load_moment_nm;
            sum_of_squares += sample.load_moment_nm * sample.load_moment_nm;
        }
        const double count = static_cast<double>(drives_[i]->samples.size());
        const double variation = sum_of_squares - sum * sum / count;
        return DriveResidual{drives_[i]->name, std::sqrt(squares / count), 1.0 - squares / variation,
                             fit.value[2 + static_cast<Eigen::Index>(i)]};
    }

    std::size_t count() const { return drives_.size(); }

 private:
    static double load_rms(const PreparedDrive& drive) {
        double sum = 0.0;
        for (const RollSample& sample : drive.samples) {
            sum += sample.load_moment_nm * sample.load_moment_nm;
        }
        return std::sqrt(sum / static_cast<double>(drive.samples.size()));
    }

    double unsprung_moment_kgm() const { return vehicle_.unsprung_mass_kg * vehicle_.unsprung_cg_height_m; }

    double known_removed(const RollSample& sample) const {
        return sample.load_moment_nm - unsprung_moment_kgm() * sample.parallel_mps2;
    }

    Eigen::VectorXd psi(std::size_t drive, const RollSample& sample) const {
        Eigen::VectorXd psi = Eigen::VectorXd::Zero(2 + static_cast<Eigen::Index>(drives_.size()));
        psi[0] = vehicle_.sprung_mass_kg * (sample.overturning_mps2 - sample.parallel_mps2) +
                 (unsprung_moment_kgm() - inertia_share_) * sample.roll_acceleration_radps2;
        psi[1] = vehicle_.sprung_mass_kg * sample.parallel_mps2;
        psi[2 + static_cast<Eigen::Index>(drive)] = 1.0;
        return psi;
    }

    const VehicleData& vehicle_;
    double inertia_share_;  // Ixx / H
    std::vector<const PreparedDrive*> drives_;
};

}  // namespace

std::optional<LoadFit> fit_loads(const VehicleData& vehicle, const RollFit& roll,
                                 const std::vector<PreparedDrive>& drives) {
    const LoadProblem problem{vehicle, roll, drives};
    if (problem.empty()) {
        return std::nullopt;
    }
    const double h = vehicle.sprung_cg_height_m;
    const LinearFit trusted = problem.solve(h, cg_height_trust * h);
    const LinearFit free = problem.solve(h, cg_height_search * h);
    LoadFit fit;
    fit.arm_m = {trusted.value[0], trusted.deviation[0], roll_centre_deviation_m};
    fit.free_cg_height_m = {free.value[1], free.deviation[1], cg_height_search * h};
    fit.condition_number = free.condition_number;
    fit.roll_centre_height_m = h - fit.arm_m.value;
    fit.lateral_share_kgm = vehicle.sprung_mass_kg * fit.roll_centre_height_m +
                            vehicle.unsprung_mass_kg * vehicle.unsprung_cg_height_m;
    for (std::size_t i = 0U; i < problem.count(); ++i) {
        fit.drives.push_back(problem.residual(i, trusted));
    }
    return fit;
}

}  // namespace sil
