// Indices: the firmware's own scale for each of its indicators, and a reference.
#include "sil/studies/campaign/indices.hpp"

#include <cmath>
#include <cstdint>

#include "rsi/parameters.hpp"
#include "rsi/warning/indicator_level.hpp"
#include "sil/results/indices.hpp"

namespace sil {
namespace {

std::function<rsi::RiskLevel(const IndexSample&)> risk_of(std::int32_t indicator) {
    return [indicator](const IndexSample& sample) {
        rsi::Parameters parameters = sample.parameters;
        parameters.warning_indicator = indicator;
        rsi::WarningIndicator reader;
        reader.init(parameters);
        const rsi::IndicatedRisk risk = reader.evaluate(sample.outputs, sample.roll_angle_rad);
        return rsi::RiskLevel{risk.level, risk.direction, risk.opposite};
    };
}

rsi::RiskLevel true_load_transfer(const IndexSample& sample) {
    const auto ratio = static_cast<float>(true_load_transfer_ratio(sample.truth));
    return {std::abs(ratio), ratio};
}

std::vector<Index> all_indices() {
    std::vector<Index> indices;
    for (const char* name : rsi::indicator_choices) {
        indices.push_back({name, risk_of(static_cast<std::int32_t>(indices.size()))});
    }
    indices.push_back({"true_load_transfer", true_load_transfer});
    return indices;
}

}  // namespace

const std::vector<Index>& campaign_indices() {
    static const std::vector<Index> indices = all_indices();
    return indices;
}

}  // namespace sil
