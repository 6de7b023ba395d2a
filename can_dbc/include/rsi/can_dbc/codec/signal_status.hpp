// Validity of a decoded signal.
#pragma once

#include <cstdint>
#include <limits>

namespace rsi::can_dbc {

enum class SignalStatus : std::uint8_t {
    valid,
    not_available,  // the sender says that it has no value
    out_of_range,   // outside the range, or not among the enumerators, that the DBC file defines
};

// The value of a physical signal that has none: what `decode` gives, and what `encode` sends as the signal's
// "not available" code.
inline constexpr float not_available = std::numeric_limits<float>::quiet_NaN();

}  // namespace rsi::can_dbc
