// Output columns: the outputs of the firmware as columns of a CSV file, one for each row of its table.
#pragma once

#include <string>
#include <vector>

#include "rsi/types.hpp"

namespace sil {

// Angles in degrees, because people read them (their names end in _deg); everything else as rsi_outputs.h
// says.
struct OutputColumn {
    std::string name;
    float rsi::Outputs::* member;
    double factor;

    double value(const rsi::Outputs& outputs) const { return static_cast<double>(outputs.*member) * factor; }
};

// Every number of rsi_outputs, in its order.
const std::vector<OutputColumn>& output_columns();

}  // namespace sil
