// Indices: the firmware's own scale for each of its indicators, and a reference.
#include "sil/studies/campaign/indices.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "rsi/parameters.hpp"
#include "sil/results/indices.hpp"

namespace sil {
namespace {

rsi::RiskLevel true_load_transfer(const Truth& truth) {
    const auto ratio = static_cast<float>(true_load_transfer_ratio(truth));
    return {std::abs(ratio), ratio};
}

std::vector<Index> all_indices() {
    std::vector<Index> indices;
    for (const char* name : rsi::indicator_choices) {
        indices.push_back({name});
    }
    indices.push_back({"true_load_transfer"});
    return indices;
}

}  // namespace

const std::vector<Index>& campaign_indices() {
    static const std::vector<Index> indices = all_indices();
    return indices;
}

std::optional<std::size_t> index_place(const std::string& name) {
    const std::vector<Index>& indices = campaign_indices();
    const auto found = std::find_if(indices.begin(), indices.end(),
                                    [&name](const Index& index) { return index.name == name; });
    return found == indices.end() ? std::nullopt
                                  : std::optional{static_cast<std::size_t>(found - indices.begin())};
}

IndexReaders::IndexReaders(const rsi::Parameters& calibration)
    : indicators_(std::size(rsi::indicator_choices)) {
    rsi::Parameters parameters = calibration;
    parameters.warning_indicator = 0;
    for (rsi::WarningIndicator& indicator : indicators_) {
        indicator = rsi::WarningIndicator{parameters};
        ++parameters.warning_indicator;
    }
}

rsi::RiskLevel IndexReaders::risk(std::size_t index, const IndexSample& sample) const {
    if (index >= indicators_.size()) {
        return true_load_transfer(sample.truth);
    }
    const rsi::IndicatedRisk risk = indicators_[index].evaluate(sample.outputs, sample.roll_angle_rad);
    return {risk.level, risk.direction, risk.opposite};
}

}  // namespace sil
