// Place of the roll centre, and the roll moment of its movement: equations (6) and (7).
#pragma once

#include "rsi/estimation/roll_centre_estimate.hpp"
#include "rsi/estimation/roll_plane_model.hpp"

namespace rsi {

// c_rc of (6), before its small-angle form: H tan phi_f - (H - dh) tan phi_m. Metres, > 0 towards the side to
// which the CG moves for phi > 0.
float lateral_roll_centre_m(const Vehicle& vehicle, const Measurement& measured, const FixedModelRoll& fixed,
                            float vertical_movement_m);

// M_add of (7) with N' in place of the flat-road m_s g: -[A' dh + N' c_rc + dK phi_m + dc phi_m'], and the
// roll inertia's moment where the estimator knows one: (1) has no inertia, the vehicle has.
float additional_roll_moment_nm(const Vehicle& vehicle, const Measurement& measured,
                                const RollCentreEstimate& estimate, float lateral_roll_centre_m);

}  // namespace rsi
