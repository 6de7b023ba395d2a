// Regression form of the difference between the fixed-roll-centre model and the measured vehicle, (4) and
// (5).
#pragma once

#include "rsi/estimation/roll_plane_model.hpp"
#include "rsi/measurement/measurement.hpp"
#include "rsi/numeric/matrix.hpp"

namespace rsi {

// Y = psi^T theta,  theta = [dh; dK; dc].
struct Regression {
    float output_nm;  // Y
    Vector3 psi;      // [A' + N' tan phi_m  (N); phi_m (rad); phi_m' (rad/s)]
};

// `fixed` must have been updated with the same measurement.
Regression regress(const Vehicle& vehicle, const Measurement& measured, const FixedModelRoll& fixed);

}  // namespace rsi
