// Vehicle lengths: what follows from the parameters' heights and track width alone.
#pragma once

#include "rsi/types.hpp"

namespace rsi {

// H = h_cg,s - h_frc: the arm of the sprung mass about the fixed roll centre.
constexpr float roll_arm_m(const Parameters& parameters) {
    return parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m;
}

// c_w / (2 h_cg,s). Accepted parameters: the height is above zero.
constexpr float static_stability_factor(const Parameters& parameters) {
    return parameters.track_width_m / (2.0F * parameters.sprung_cg_height_m);
}

}  // namespace rsi
