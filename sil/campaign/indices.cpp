// Indices: the table, one line an index.
#include "sil/campaign/indices.hpp"

#include <cmath>
#include <limits>

namespace sil {
namespace {

double published_rsi(const IndexSample& sample) {
    return static_cast<double>(sample.outputs.rsi);
}

double bank_free_rsi(const IndexSample& sample) {
    return static_cast<double>(sample.outputs.rsi_bank_free);
}

// |a_y| / (g SSF), SSF = c_w/(2 h) as the firmware knows them.
double static_stability(const IndexSample& sample) {
    const double limit_mps2 = static_cast<double>(rsi::gravity_mps2) *
                              static_cast<double>(sample.parameters.track_width_m) /
                              (2.0 * static_cast<double>(sample.parameters.sprung_cg_height_m));
    return std::abs(static_cast<double>(sample.outputs.lateral_acceleration_mps2)) / limit_mps2;
}

double true_load_transfer(const IndexSample& sample) {
    return std::abs(load_transfer_ratio(sample.truth));
}

}  // namespace

const std::vector<Index>& campaign_indices() {
    static const std::vector<Index> indices{
        {"rsi", published_rsi},
        {"rsi_bank_free", bank_free_rsi},
        {"static_stability", static_stability},
        {"true_ltr", true_load_transfer},
    };
    return indices;
}

double load_transfer_ratio(const Truth& truth) {
    const auto& load = truth.wheel_load_n;
    const double left_n = load[front_left] + load[rear_left];
    const double right_n = load[front_right] + load[rear_right];
    const double sum_n = left_n + right_n;
    return sum_n > 0.0 ? (left_n - right_n) / sum_n : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace sil
