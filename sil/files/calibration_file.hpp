// Calibration file: the component's parameters as TOML.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "rsi/types.hpp"

namespace sil {

// What is wrong with a calibration file, with file, line and key, ready to be shown.
class CalibrationError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Reads every key of rsi_parameters from `path` and validates them as the component will. Throws
// CalibrationError for a file that cannot be read or parsed, an unknown, missing or mistyped key, and a value
// that the component refuses.
rsi::Parameters load_calibration(const std::string& path);

// The same with values changed, each as "key=value", the value as in the file; a word needs no quotes.
rsi::Parameters load_calibration(const std::string& path, const std::vector<std::string>& changes);

}  // namespace sil
