// Corridor: the bounds about a measured signal within which a prediction may lie.
#pragma once

#include <vector>

namespace sil {

// A bound is offset + share |measured| away from the measured signal, of which within so much time the
// extreme counts.
struct Tolerance {
    double offset{};
    double share{};
    double time_s{};
};

struct Corridor {
    std::vector<double> lower{};
    std::vector<double> upper{};
};

// `measured` has a value every `step_s`, all of them finite.
Corridor corridor_about(const std::vector<double>& measured, double step_s, const Tolerance& tolerance);

// Share of the values that count that lies within; one that is not finite does not. NaN when none counts.
// All are as long as the corridor.
double share_within(const Corridor& corridor, const std::vector<double>& predicted,
                    const std::vector<bool>& counts);

}  // namespace sil
