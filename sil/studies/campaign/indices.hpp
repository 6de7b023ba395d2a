// Indices: every measure of rollover risk that a campaign compares, as a level at which 1 means "warn".
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "rsi/warning/warning_state_machine.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

// What an index may look at in one cycle. A vehicle has no truth: an index that reads it is a reference.
struct IndexSample {
    const rsi::Outputs& outputs;
    const Truth& truth;
    const rsi::Parameters& parameters;  // of the firmware, wrong as they may be
    float roll_angle_rad{0.0F};         // that the firmware uses; for the side of some
};

struct Index {
    std::string name;  // of its columns
    // The level, 0 and above, NaN where there is none, and the side.
    std::function<rsi::RiskLevel(const IndexSample&)> risk;

    double level(const IndexSample& sample) const { return static_cast<double>(risk(sample).indicator); }
};

// In the order of their columns: every indicator that the firmware can be told to warn by, under the name
// that a calibration knows it by, and then what only the true wheel loads tell.
const std::vector<Index>& campaign_indices();

}  // namespace sil
