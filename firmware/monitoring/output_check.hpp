// Output check: whether what the component has computed can be told.
#pragma once

#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace monitoring {

// A cycle without a roll angle has computed nothing, and says "unavailable".
inline bool has_computed(const rsi::Outputs& outputs) noexcept {
    return outputs.roll_source != RSI_ROLL_NONE;
}

// No suspension moves its roll centre by 2 m or has ten times the damping of a heavy one; the stiffness is
// that of the bump stops too, which grow with the fourth power of the angle. A number that is not finite is
// out of range.
inline bool estimate_is_in_range(const rsi::Outputs& outputs) noexcept {
    return rsi::is_within_magnitude(outputs.roll_centre_vertical_m, 2.0F) &&
           rsi::is_within_magnitude(outputs.roll_stiffness_deviation_nmprad, 1.0e10F) &&
           rsi::is_within_magnitude(outputs.roll_damping_deviation_nmsprad, 1.0e5F);
}

// Everything that has a number whenever the component has computed, and the enumerations: it looks for codes
// that these do not have, which a sanitizer would take amiss.
__attribute__((no_sanitize("enum"))) inline bool outputs_are_sound(const rsi::Outputs& outputs) noexcept {
    const auto state = static_cast<unsigned>(outputs.state);
    const auto side = static_cast<unsigned>(outputs.side);
    const auto source = static_cast<unsigned>(outputs.roll_source);
    return (state <= RSI_STATE_WARNING) && (side <= RSI_SIDE_RIGHT) && (source <= RSI_ROLL_OBSERVER) &&
           rsi::is_finite(outputs.warning_level) && rsi::is_finite(outputs.rsi) &&
           rsi::is_finite(outputs.rsi_bank_free) && rsi::is_finite(outputs.rsi_extended) &&
           rsi::is_finite(outputs.lateral_acceleration_mps2) &&
           rsi::is_finite(outputs.lateral_acceleration_threshold_mps2) &&
           rsi::is_finite(outputs.roll_centre_lateral_m) && rsi::is_finite(outputs.load_transfer_ratio) &&
           rsi::is_finite(outputs.predicted_load_transfer_ratio) && rsi::is_finite(outputs.predicted_rsi) &&
           rsi::is_finite(outputs.dynamic_stability_index) && rsi::is_finite(outputs.energy_margin) &&
           rsi::is_finite(outputs.rollover_index) && rsi::is_finite(outputs.time_to_rollover_s);
}

// Takes back the statement on the risk.
inline void withdraw(rsi::Outputs& outputs) noexcept {
    outputs.state = RSI_STATE_UNAVAILABLE;
    outputs.side = RSI_SIDE_NONE;
    outputs.warning_level = rsi::not_available;
    outputs.lateral_acceleration_mps2 = rsi::not_available;
    outputs.lateral_acceleration_threshold_mps2 = rsi::not_available;
}

}  // namespace monitoring
