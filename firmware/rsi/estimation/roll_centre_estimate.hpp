// Outputs of every roll-centre estimator.
#pragma once

#include "rsi/numeric/bounded.hpp"

namespace rsi {

struct RollCentreEstimate {
    float vertical_movement_m{0.0F};         // dh = h_rc - h_frc
    float stiffness_deviation_nmprad{0.0F};  // dK = K_m - K_f
    float damping_deviation_nmsprad{0.0F};   // dc = c_m - c_f
    float disturbance_nm{0.0F};              // d, in units of Y
    float inertia_moment_nm{0.0F};           // -Ixx phi''; 0 of an estimator whose model has no inertia
    float deviation_m{not_available};        // standard deviation of dh; not of every estimator
    bool frozen{false};                      // nothing is learnt at present
};

}  // namespace rsi
