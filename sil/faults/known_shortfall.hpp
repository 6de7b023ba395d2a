// Known shortfall: where the firmware does less than is expected, and why. The expectation stays as it is.
#pragma once

#include <vector>

#include "sil/faults/fault.hpp"

namespace sil {

struct KnownShortfall {
    FaultKind kind{};
    std::vector<FaultPlace> places{};   // empty: all
    std::vector<const char*> scenes{};  // by name; empty: all
    const char* why{""};                // a sentence for the page
};

// A cell that falls short and is not in this list fails the run; so does an entry without any such cell.
const std::vector<KnownShortfall>& known_shortfalls();

bool concerns(const KnownShortfall& known, const Fault& fault, const std::string& scene);

}  // namespace sil
