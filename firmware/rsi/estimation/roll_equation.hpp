// Roll equation of the sprung mass through two equal lags: what it leaves for the roll centre's movement.
#pragma once

#include "rsi/measurement/measurement.hpp"
#include "rsi/model/vehicle.hpp"
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
    struct Constants {
        Constants() = default;
        [[gnu::cold]] explicit Constants(const Parameters& parameters);

        float weight{};  // of a new value in each lag
        int settling_samples{};
    };

    // The next measurement starts the lags anew.
    void reset() { samples_ = 0; }

    RollEquation update(const Constants& constants, const Vehicle& vehicle, const Measurement& measured);

 private:
    int samples_{};

    TwoLags moment_{};  // m_s H f - M(phi) - c phi'
    TwoLags force_{};   // m_s f
    TwoLags rate_{};    // phi'
};

}  // namespace rsi
