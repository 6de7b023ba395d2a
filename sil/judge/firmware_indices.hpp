// Firmware indices: level and side of every index that the firmware can warn by, whichever it does warn by.
#pragma once

#include <array>
#include <cstddef>

#include "rsi/output_table.hpp"
#include "rsi/types.hpp"
#include "rsi/warning/indicator_level.hpp"
#include "rsi/warning/warning_state_machine.hpp"

namespace sil {

// The roll angle that the firmware used in a cycle, for the side of some indices.
float roll_angle_in_use(const rsi::Inputs& inputs, const rsi::Outputs& outputs);

// Made once a run, for they are read in every cycle.
class FirmwareIndices {
 public:
    explicit FirmwareIndices(const rsi::Parameters& calibration);

    // Level, 0 and above, NaN if there is none, and side of the index at this place of
    // rsi::indicator_choices.
    rsi::RiskLevel risk(std::size_t index, const rsi::Outputs& outputs, float roll_angle_rad) const;

 private:
    std::array<rsi::WarningIndicator, rsi::index_count> indicators_{};
};

}  // namespace sil
