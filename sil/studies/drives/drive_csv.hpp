// Drive CSV: reads a drive from comma-separated values whose header names quantities and units.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sil/input_error.hpp"
#include "sil/studies/drives/drive.hpp"

namespace sil {

// The columns, units and rules are those of docs/drives.md; signals.csv of a run is such a file. Throws
// InputError: "FILE:LINE:COLUMN: what is wrong; what to do", lines and columns (characters) from 1.
Drive read_drive_csv(const std::filesystem::path& path);

// The same for text at hand; `file` is what errors call it and what the drive's name is made of.
Drive parse_drive_csv(std::string_view text, const std::filesystem::path& file);

}  // namespace sil
