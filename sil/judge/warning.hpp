// Warning: state and side, as the ECU's frame names them.
#pragma once

#include "rsi/can_dbc/generated/rollover_warning.hpp"

namespace sil {

using WarningState = rsi::can_dbc::RolloverWarning::State;
using WarningSide = rsi::can_dbc::RolloverWarning::Side;  // towards which the vehicle would fall

// "unavailable", "ready", ... ; "none", "left", "right".
inline const char* to_string(WarningState state) {
    return rsi::can_dbc::RolloverWarning::name_of(state);
}
inline const char* to_string(WarningSide side) {
    return rsi::can_dbc::RolloverWarning::name_of(side);
}

}  // namespace sil
