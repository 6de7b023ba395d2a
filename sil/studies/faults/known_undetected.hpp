// Known undetected errors: no check finds them before the warning that they delay is due.
#pragma once

#include <vector>

#include "sil/studies/faults/fault.hpp"

namespace sil {

struct KnownUndetected {
    FaultKind kind{};
    FaultPlace place{};
    int sign{0};  // of the error, in a left turn; 0: it has none
    const char* why{""};
};

// The limit of the component: each makes some due warning late or silent, without a diagnostic code in time.
const std::vector<KnownUndetected>& known_undetected_errors();

// The same of the failures that only the matrix of states injects, or of which no time is stated.
const std::vector<KnownUndetected>& undetected_in_states();

// `fault` of a left turn.
bool is_known_undetected(const Fault& fault);

// The fault in the mirrored drive.
Fault in_turn_to_the_other_side(const Fault& fault);

}  // namespace sil
