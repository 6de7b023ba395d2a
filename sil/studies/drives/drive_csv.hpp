// Drive CSV: reads a drive from comma-separated values whose header names quantities and units.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "sil/studies/drives/drive.hpp"

namespace sil {

// what() is "FILE:LINE:COLUMN: what is wrong; what to do". Lines and columns (characters) count from 1.
class DriveCsvError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

// The columns, units and rules are those of docs/drives.md; signals.csv of a run is such a file. Throws
// DriveCsvError, for a file that cannot be read too (then at line 1, column 1).
Drive read_drive_csv(const std::filesystem::path& path);

// The same for text at hand; `file` is what errors call it and what the drive's name is made of.
Drive parse_drive_csv(std::string_view text, const std::filesystem::path& file);

}  // namespace sil
