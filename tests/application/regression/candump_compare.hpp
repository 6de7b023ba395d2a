// Comparison of two candump logs, with a difference that a person can read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sil/files/candump_log.hpp"

namespace sil {

struct CompareOptions {
    // Largest difference between the times of two frames that count as equal.
    std::int64_t time_tolerance_us{0};
    // Times count from the first frame of each log: for a replay in real time.
    bool times_relative_to_first{false};
    // Frames shown before and after the first difference.
    std::size_t context_frames{3U};
    // Differences shown; all are counted.
    std::size_t differences_shown{10U};
    // Meaning of a frame ("RolloverWarning state=warning ..."), appended to its line; may be empty.
    std::function<std::string(const rsi::hal::CanFrame&)> describe;
};

struct LogComparison {
    bool equal{true};
    std::size_t differences{0U};
    std::string report;  // one line when equal; else the counts, then the differences like a diff
};

// Identifiers, frame kinds, CAN FD flags, payloads and their order must be the same, times within the
// tolerance. Names of interfaces do not count. A frame that is missing from or added to `actual` is reported
// as one difference, provided that the logs agree again within 32 frames. In the report '-' is expected, '+'
// is actual, '^' marks bytes.
LogComparison compare_logs(const std::vector<LoggedFrame>& expected, const std::vector<LoggedFrame>& actual,
                           const CompareOptions& options = {});

}  // namespace sil
