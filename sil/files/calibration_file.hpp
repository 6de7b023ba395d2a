// Calibration file: the component's parameters as TOML.
#pragma once

#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/input_error.hpp"

namespace sil {

// Reads every key of rsi_parameters from `path` and validates them as the component will. `changes` are
// values in place of the file's, each as "key=value", the value as in the file; a word needs no quotes.
// Throws InputError for a file that cannot be read or parsed, an unknown, missing or mistyped key, and a
// value that the component refuses.
rsi::Parameters load_calibration(const std::string& path, const std::vector<std::string>& changes = {});

}  // namespace sil
