// Peaks: how high an index came in a run, as far as it could have warned of two-wheel lift-off.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace sil {

// A peak counts only what lasted as many cycles as the firmware wants for a warning (warning_confirmation_s),
// so that an index driving the warning at threshold x would have warned exactly in the runs whose peak is at
// least x.
struct IndexPeaks {
    double whole{0.0};         // over the run, but not beyond two-wheel lift-off
    double before_100ms{0.0};  // up to 0.1 s before two-wheel lift-off; as `whole` when there is none
    std::optional<double> first_time_s{};  // at level 1, within the time of `whole`
};

// Of the levels at the times of the cycles. `cycles`: so many in a row must reach a level; 0 is as 1. A level
// that is not a number reaches nothing.
IndexPeaks peaks_of(const std::vector<double>& times_s, const std::vector<double>& levels, std::size_t cycles,
                    const std::optional<double>& lift_time_s);

}  // namespace sil
