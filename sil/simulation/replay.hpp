// Replay: recorded sensor frames through the firmware, in simulated time.
#pragma once

#include <vector>

#include "rsi/types.hpp"
#include "sil/analysis/candump_log.hpp"

namespace sil {

// What the firmware with these parameters sends, stepped every 10 ms from the first frame's time until the
// last frame. Frames that the firmware itself sends are left out of the input, so a log of a whole run can be
// replayed. A frame that is due at the instant of a step is received by it. Throws std::invalid_argument when
// the parameters are refused.
std::vector<LoggedFrame> replay(const std::vector<LoggedFrame>& log, const rsi::Parameters& parameters);

}  // namespace sil
