// Indices: every measure of rollover risk that a campaign compares, as a level at which 1 means "warn".
#pragma once

#include <vector>

#include "rsi/types.hpp"
#include "sil/vehicle/truth.hpp"

namespace sil {

// What an index may look at in one cycle. A vehicle has no truth: an index that reads it is a reference.
struct IndexSample {
    const rsi::Outputs& outputs;
    const Truth& truth;
    const rsi::Parameters& parameters;  // of the firmware, wrong as they may be
};

struct Index {
    const char* name;                            // of its columns
    double (*level)(const IndexSample& sample);  // 0 and above; NaN where there is none
};

// In the order of their columns. A new index is one line in indices.cpp.
const std::vector<Index>& campaign_indices();

// Load transfer ratio of the four true wheel loads, (left - right) / sum, so below 0 in a left turn; NaN
// while no wheel touches the road.
double load_transfer_ratio(const Truth& truth);

}  // namespace sil
