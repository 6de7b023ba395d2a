// Dear drive: a sequence of inputs made to lead the component along its longest ways.
#pragma once

#include <cstdint>
#include <vector>

#include "rsi/types.hpp"
#include "tests/targets/budgets/recording.hpp"

namespace budgets {

struct DearDriveOptions {
    int samples{500};             // 10 ms each; the sensors fail in turns of 500
    int alternatives_every{100};  // samples
    std::uint64_t seed{71U};
};

// Random driving at the limits, with sensors that fail and come back, a vehicle that lies on its side and is
// put up again, levels crossed in both directions; and at many instants a set of "what if this came next"
// on a copy: each combination of missing inputs, a roll angle that contradicts, the other side, an overturn.
std::vector<Record> dear_drive(const rsi::Parameters& parameters, const DearDriveOptions& options);

}  // namespace budgets
