// Statistics: shares with their confidence, and quantiles.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace sil {

struct ConfidenceInterval {
    double lowest{0.0};
    double highest{1.0};
};

// Wilson's score interval of a binomial share, 95 % (E. B. Wilson, JASA 22, 1927); `count` of `total`. From 0
// to 1 when the total is 0.
ConfidenceInterval wilson_interval(std::size_t count, std::size_t total);

// So many of so many.
struct Share {
    std::size_t count{0U};
    std::size_t total{0U};

    void add(bool counts) {
        count += counts ? 1U : 0U;
        ++total;
    }
    // NaN when the total is 0.
    double value() const;
    ConfidenceInterval confidence() const { return wilson_interval(count, total); }
};

// The value below which `share` (0 to 1) of the values lie, linear between neighbours: the smallest value at
// 0, the largest at 1. Empty when there are none. `values` need not be sorted.
std::optional<double> quantile(std::vector<double> values, double share);

}  // namespace sil
