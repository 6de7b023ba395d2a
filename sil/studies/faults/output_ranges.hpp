// Output ranges: what the component may give, whatever it has been given.
#pragma once

#include "rsi/types.hpp"

namespace sil {

// Every number NaN or finite; what drives the warning there whenever there is a statement; estimates within
// what the bus can carry.
bool are_in_range(const rsi::Outputs& outputs);

}  // namespace sil
