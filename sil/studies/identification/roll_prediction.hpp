// Roll prediction: how the body rolls, and how the force follows the steering, by the models of a calibration
// alone.
#pragma once

#include <vector>

#include "rsi/types.hpp"
#include "sil/studies/identification/prepared_drive.hpp"
#include "sil/studies/identification/response_fit.hpp"
#include "sil/studies/identification/roll_fit.hpp"

namespace sil {

// Ixx phi'' = m_s H (A + N tan phi) - M(phi) - c phi', M(phi) = K_f phi + K_2 phi^3 + K_4 phi^5.
struct RollModel {
    double mass_arm_kgm{};  // m_s H
    double inertia_kgm2{};
    double damping_nmsprad{};
    double stiffness_nmprad{};
    double cubic_nmprad3{};
    double quintic_nmprad5{};
};

RollModel roll_model(const VehicleData& vehicle, const RollFit& fit);
RollModel roll_model(const rsi::Parameters& parameters);

// The roll angle at each sample. Only the measured forces A and N of the drive are used, and the beginning
// of the roll motion. NaN from where the model tips over, beyond one radian.
std::vector<double> predicted_roll_angles_rad(const RollModel& model, const std::vector<RollSample>& samples);

// c_w/2 (F_zR - F_zL) as the component has it: alpha A + M(phi) + c phi'.
double load_moment_nm(const rsi::Parameters& parameters, const RollSample& sample);

// A at each sample, as A'' = w^2 (a_d - A) - 2 zeta w A' has it from the steering alone and the beginning of
// A. Starts anew after samples at which the steering's demand is not known, where it is NaN.
std::vector<double> response_mps2(const SteeringModel& model, double frequency_radps, double damping,
                                  const std::vector<RollSample>& samples);

}  // namespace sil
