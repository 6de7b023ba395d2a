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
ConfidenceInterval wilson_interval(double count, double total);

// A count out of a total.
struct Share {
    std::size_t count{0U};
    std::size_t total{0U};
    // As many independent trials say as much; 0: all of them are independent.
    double independent{0.0};

    void add(bool counts) {
        count += counts ? 1U : 0U;
        ++total;
    }
    // NaN when the total is 0.
    double value() const;
    ConfidenceInterval confidence() const;
};

// From so many vehicles on, their runs are not taken for independent.
inline constexpr std::size_t fewest_clusters = 10U;

// A share of runs by vehicle. The runs of one vehicle are alike, so what counts for the interval are the
// vehicles: the variance of the ratio estimator over them gives the number of independent runs that would
// have it (the design effect of survey sampling; Wilson's interval with it). If all runs or none count there
// is no variance, and the number of vehicles is taken.
class ShareByVehicle {
 public:
    // Vehicles are numbered from 0, without great gaps.
    void add(std::size_t vehicle, bool counts) { add(vehicle, counts ? 1U : 0U, 1U); }
    void add(std::size_t vehicle, std::size_t count, std::size_t total) {
        if (vehicle >= vehicles_.size()) {
            vehicles_.resize(vehicle + 1U);
        }
        vehicles_[vehicle].count += count;
        vehicles_[vehicle].total += total;
    }
    Share share() const;

 private:
    std::vector<Share> vehicles_{};
};

// The value below which `share` (0 to 1) of the values lie, linear between neighbours: the smallest value at
// 0, the largest at 1. Empty when there are none. `values` need not be sorted.
std::optional<double> quantile(std::vector<double> values, double share);

}  // namespace sil
