// Output check: whether what the component has computed can be published.
#pragma once

#include "rsi/adaptation/load_bounds.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/output_table.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// A cycle without a roll angle has computed nothing, and says "unavailable".
inline bool has_computed(const rsi::Outputs& outputs) noexcept {
    return outputs.roll_source != RSI_ROLL_NONE;
}

// No suspension moves its roll centre by 2 m or has ten times the damping of a heavy one; the stiffness is
// that of the bump stops too, which grow with the fourth power of the angle. The load has its own bounds. A
// number that is not finite is out of range.
inline bool estimate_is_in_range(const rsi::Outputs& outputs) noexcept {
    return rsi::is_within_magnitude(outputs.roll_centre_vertical_m, 2.0F) &&
           rsi::is_within_magnitude(outputs.roll_stiffness_deviation_nmprad, 1.0e10F) &&
           rsi::is_within_magnitude(outputs.roll_damping_deviation_nmsprad, 1.0e5F) &&
           rsi::is_within(outputs.load_excess, rsi::least_load_excess, rsi::largest_load_excess) &&
           rsi::is_within(outputs.load_excess_deviation, 0.0F, rsi::largest_load_excess_deviation);
}

// Everything that the table of outputs says is always there.
inline bool outputs_are_sound(const rsi::Outputs& outputs) noexcept {
    return rsi::are_codes_known_and_numbers_finite(outputs);
}

// Takes back the statement on the risk.
inline void withdraw(rsi::Outputs& outputs) noexcept {
    rsi::reset_statement(outputs);
}

}  // namespace rsi::monitoring
