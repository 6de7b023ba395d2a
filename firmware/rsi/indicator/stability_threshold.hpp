// Stability threshold: the lateral acceleration at which the inner wheels lift, equations (19) to (23).
#pragma once

#include "rsi/measurement/measurement.hpp"
#include "rsi/model/vehicle.hpp"
#include "rsi/types.hpp"

namespace rsi {

struct StabilityThreshold {
    float side{1.0F};                       // +1 in a left turn (A >= 0), -1 in a right turn
    float half_track_ratio{1.0F};           // T of the side, not below 0.05
    float lateral_acceleration_mps2{0.0F};  // a_y*, signed like the side, at least 0.05 g
    bool is_defined{true};  // false where the bank alone (nearly) lifts the wheels: a_y* near 0 or past it
};

// T = [c_w/2 - s c_rc - s (h - h_rc) tan phi] / h  on side s, and a_y*/g = s (e + T) / (1 - e T) with
// e = -s tan b. The side is that of A, not of a_y: on a bank they can differ.
StabilityThreshold stability_threshold(const Vehicle& vehicle, const Measurement& measured,
                                       float vertical_movement_m, float lateral_movement_m);

}  // namespace rsi
