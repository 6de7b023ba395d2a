// Serial state: the state of an instance as bytes, for another process on the same kind of machine.
#pragma once

#include <string>

#include "sil/exchange/fmu/instance.hpp"

namespace fmu {

// Empty if the model cannot be serialised.
std::string to_bytes(const SavedState& state);

// Into a state of the same FMU. False, and nothing has changed, where `bytes` are of another FMU or damaged.
bool from_bytes(const std::string& bytes, SavedState& state);

}  // namespace fmu
