// Indices that need wheel loads, or the true motion.
#include "sil/results/indices.hpp"

#include <cmath>
#include <limits>

namespace sil {
namespace {

double ratio(double left_n, double right_n) {
    const double sum_n = left_n + right_n;
    return (sum_n > 0.0) ? (right_n - left_n) / sum_n : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double true_load_transfer_ratio(const Truth& truth) {
    const auto& load = truth.wheel_load_n;
    return ratio(load[front_left] + load[rear_left], load[front_right] + load[rear_right]);
}

double true_load_transfer_ratio(const Truth& truth, Axle axle) {
    const auto& load = truth.wheel_load_n;
    return (axle == Axle::front) ? ratio(load[front_left], load[front_right])
                                 : ratio(load[rear_left], load[rear_right]);
}

}  // namespace sil
