// Bus timing: the ECU's punctuality and reaction time, measured from outside by a candump log.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "sil/files/candump_log.hpp"

namespace sil {

// Percentiles of at least one duration, in milliseconds.
struct DurationStatistics {
    double median_ms{0.0};
    double percentile_99_ms{0.0};
    double largest_ms{0.0};
};

struct BusTiming {
    std::size_t warning_frames{0U};
    double duration_s{0.0};  // from the first to the last warning frame
    // |distance of two warning frames - 10 ms|; empty when there is but one warning frame
    std::optional<DurationStatistics> cycle_jitter;
    // from the last sensor frame to the warning frame that follows it; empty when none follows one
    std::optional<DurationStatistics> reaction_time;
};

// A log that says nothing about the ECU's timing; what() says why.
class NoTiming : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

// Times are those of the log, so it must be one of `candump -L` in real time: throws NoTiming when it is of a
// run in lock-step (there are SimulationSync frames in it) or without warning frames.
BusTiming bus_timing(const std::vector<LoggedFrame>& log);

// A few lines for people.
std::string describe(const BusTiming& timing);

}  // namespace sil
