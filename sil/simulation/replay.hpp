// Replay: recorded sensor frames through the firmware, in simulated time.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/files/candump_log.hpp"

namespace sil {

// A log that cannot be replayed; `line` is where it is wrong, 0 when it is wrong as a whole.
class ReplayError : public std::runtime_error {
 public:
    ReplayError(std::size_t line, const std::string& message) : std::runtime_error{message}, line_{line} {}
    std::size_t line() const { return line_; }

 private:
    std::size_t line_;
};

// The sensor frames of a log in the order of their times; those of one time in the order of the log. Throws
// ReplayError when there is none, when the time goes back by more than 0.2 s, and at a gap of more than an
// hour.
std::vector<rsi::hal::CanFrame> replayable_frames(const std::vector<LoggedFrame>& log);

// Frames that the firmware with these parameters sends, stepped every 10 ms from the first frame's time until
// the last frame. Frames that the firmware itself sends are left out of the input, so a log of a whole run
// can be replayed. A frame that is due at the instant of a step is received by it. Throws what
// replayable_frames throws, and std::invalid_argument when the parameters are refused.
std::vector<LoggedFrame> replay(const std::vector<LoggedFrame>& log, const rsi::Parameters& parameters);

}  // namespace sil
