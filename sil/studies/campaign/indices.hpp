// Indices: every measure of rollover risk that a campaign compares, as a level at which 1 means "warn".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "rsi/warning/warning_state_machine.hpp"
#include "sil/judge/firmware_indices.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

// Inputs of an index in one cycle. A vehicle has no truth: an index that reads it is a reference.
struct IndexSample {
    const rsi::Outputs& outputs;
    const Truth& truth;
    float roll_angle_rad{0.0F};  // roll_angle_in_use()
};

struct Index {
    std::string name;  // of its columns
};

// In the order of their columns: every indicator that the firmware can warn by, under its name in a
// calibration, and then the one of the true wheel loads.
const std::vector<Index>& campaign_indices();

// Place of the index of this name in campaign_indices(); none: there is no such index.
std::optional<std::size_t> index_place(const std::string& name);

// All of them with the calibration of one run, wrong as it may be. Made once a run, for they are read in
// every cycle.
class IndexReaders {
 public:
    explicit IndexReaders(const rsi::Parameters& calibration) : firmware_{calibration} {}

    // Level, 0 and above, NaN if there is none, and side of the index at this place of campaign_indices().
    rsi::RiskLevel risk(std::size_t index, const IndexSample& sample) const;

    double level(std::size_t index, const IndexSample& sample) const {
        return static_cast<double>(risk(index, sample).indicator);
    }

 private:
    FirmwareIndices firmware_;
};

}  // namespace sil
