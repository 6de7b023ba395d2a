// Indices: the firmware's own scale for each of its indicators, and a reference.
#include "sil/studies/campaign/indices.hpp"

#include <cmath>
#include <cstdint>

#include "rsi/parameters.hpp"
#include "rsi/warning/indicator_level.hpp"
#include "sil/results/indices.hpp"

namespace sil {
namespace {

std::function<double(const IndexSample&)> level_of(std::int32_t indicator) {
    return [indicator](const IndexSample& sample) {
        rsi::Parameters parameters = sample.parameters;
        parameters.warning_indicator = indicator;
        return static_cast<double>(rsi::indicator_level(sample.outputs, parameters));
    };
}

double true_load_transfer(const IndexSample& sample) {
    return std::abs(true_load_transfer_ratio(sample.truth));
}

std::vector<Index> all_indices() {
    std::vector<Index> indices;
    for (const char* name : rsi::indicator_choices) {
        indices.push_back({name, level_of(static_cast<std::int32_t>(indices.size()))});
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
