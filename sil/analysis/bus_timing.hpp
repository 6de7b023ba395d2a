// Bus timing: the ECU's punctuality and reaction time, measured from outside by a candump log.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sil/analysis/candump_log.hpp"

namespace sil {

// Of many durations, in milliseconds; zero when there are none.
struct DurationStatistics {
    double median_ms{0.0};
    double percentile_99_ms{0.0};
    double largest_ms{0.0};
};

struct BusTiming {
    std::size_t warning_frames{0U};
    double duration_s{0.0};            // from the first to the last warning frame
    DurationStatistics cycle_jitter;   // |distance of two warning frames - 10 ms|
    DurationStatistics reaction_time;  // from the last sensor frame to the warning frame that follows it
};

// Times are those of the log, so use one of `candump -L` in real time.
BusTiming bus_timing(const std::vector<LoggedFrame>& log);

// A few lines for people.
std::string describe(const BusTiming& timing);

}  // namespace sil
