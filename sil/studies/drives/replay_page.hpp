// Replay page: a replayed drive as the page of a run shows it.
#pragma once

#include <string>

#include "sil/studies/drives/drive_replay.hpp"
#include "sil/studies/drives/replay_summary.hpp"

namespace sil {

// report.html. `indices` is the text of indices.csv, whose numbers the page shows; a column without any value
// is left out, and the page says what is not known.
std::string replay_page(const ReplaySource& source, const DriveReplay& replay,
                        const rsi::Parameters& parameters, const std::string& indices);

}  // namespace sil
