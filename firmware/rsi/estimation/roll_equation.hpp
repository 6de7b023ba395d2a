// Roll equation of the sprung mass through two equal lags: what it leaves for the roll centre's movement.
#pragma once

#include "rsi/measurement/measurement.hpp"
#include "rsi/model/roll_stiffness_curve.hpp"
#include "rsi/model/sprung_body.hpp"
#include "rsi/numeric/two_lags.hpp"
#include "rsi/types.hpp"

namespace rsi {

// z = F[m_s H f - M(phi) - c phi'] - Ixx F[phi''] = F[m_s f] dh,  f = A + N tan phi.
struct RollEquation {
    float residual_nm{0.0F};                 // z
    float lateral_force_n{0.0F};             // F[m_s f]
    float stiffness_moment_nm{0.0F};         // M(phi), unfiltered
    float stiffness_deviation_nmprad{0.0F};  // M(phi) / phi - K_f, unfiltered
    float roll_rate_radps{0.0F};             // F[phi']
    float roll_acceleration_radps2{0.0F};    // F[phi'']
    float inertia_moment_nm{0.0F};           // Ixx F[phi'']
    bool settled{false};                     // false until the lags have forgotten how they were started
};

// F is two first-order lags in a row, and the roll acceleration is what the second one does with the roll
// rate: the difference of its output over one sample. Every other signal is the mean of its output over the
// same sample, so both sides belong to the same instant.
class FilteredRollEquation {
 public:
    [[gnu::cold]] void init(const Parameters& parameters) {
        tune(parameters);
        restart();
    }

    // The parameters from now on; the signals go on.
    [[gnu::cold]] void tune(const Parameters& parameters);

    // The body from now on.
    void assume_body(const SprungBody& body);

    // The next measurement starts the lags anew.
    void restart() { samples_ = 0; }

    RollEquation update(const Measurement& measured);

 private:
    RollStiffnessCurve curve_{};
    float sprung_mass_kg_{0.0F};
    float moment_arm_m_{0.0F};
    float damping_nmsprad_{0.0F};
    float inertia_kgm2_{0.0F};
    float weight_{1.0F};
    int settling_samples_{0};
    int samples_{0};

    TwoLags moment_{};  // m_s H f - M(phi) - c phi'
    TwoLags force_{};   // m_s f
    TwoLags rate_{};    // phi'
};

}  // namespace rsi
