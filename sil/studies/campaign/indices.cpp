// Indices: the firmware's own scale for each of its indicators, and a reference.
#include "sil/studies/campaign/indices.hpp"

#include <algorithm>
#include <cmath>

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

rsi::RiskLevel IndexReaders::risk(std::size_t index, const IndexSample& sample) const {
    return index < rsi::index_count ? firmware_.risk(index, sample.outputs, sample.roll_angle_rad)
                                    : true_load_transfer(sample.truth);
}

}  // namespace sil
