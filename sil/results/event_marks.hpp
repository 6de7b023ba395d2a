// Event marks: the run's events as gnuplot variables, so that the pictures need no JSON parser.
#pragma once

#include <filesystem>
#include <string>

#include "sil/results/events.hpp"

namespace sil {

// A file that gnuplot can `load`: title, end_time_s, ssf, and for each EVENT of warning, one_wheel_lift,
// two_wheel_lift and ssf_crossing the variables EVENT_time_s, EVENT_ay_g and EVENT_roll_deg, NaN where it did
// not happen; numbers have up to nine significant digits. `title` is shown above the pictures.
std::string event_marks(const RunEvents& events, double static_stability_factor, const std::string& title);

// Writes it atomically; `draw` expects the name events.gp. Throws std::runtime_error with path and reason.
void write_event_marks(const RunEvents& events, double static_stability_factor, const std::string& title,
                       const std::filesystem::path& path);

}  // namespace sil
