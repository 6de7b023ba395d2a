// Output check: plausibility of the component's outputs before they are sent.
#pragma once

#include "rsi/adaptation/load_bounds.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/output_table.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// Without a roll angle the component computes nothing and reports "unavailable".
inline bool has_computed(const rsi::Outputs& outputs) noexcept {
    return outputs.roll_source != RSI_ROLL_NONE;
}

// Bounds beyond any suspension: 2 m of roll centre movement, ten times the damping of a heavy vehicle. The
// stiffness is wide because it includes the bump stops, which grow with the fourth power of the angle. NaN is
// out of range.
inline bool estimate_is_in_range(const rsi::Outputs& outputs) noexcept {
    return rsi::is_within_magnitude(outputs.roll_centre_vertical_m, 2.0F) &&
           rsi::is_within_magnitude(outputs.roll_stiffness_deviation_nmprad, 1.0e10F) &&
           rsi::is_within_magnitude(outputs.roll_damping_deviation_nmsprad, 1.0e5F) &&
           rsi::is_within(outputs.load_excess, rsi::least_load_excess, rsi::largest_load_excess) &&
           rsi::is_within(outputs.load_excess_deviation, 0.0F, rsi::largest_load_excess_deviation);
}

// The codes and numbers that output_table.hpp declares as always available are valid.
inline bool outputs_are_sound(const rsi::Outputs& outputs) noexcept {
    return rsi::are_codes_known_and_numbers_finite(outputs);
}

// Invalidates the warning outputs.
inline void withdraw(rsi::Outputs& outputs) noexcept {
    rsi::reset_statement(outputs);
}

}  // namespace rsi::monitoring
