// Identify command: from test drives and a data sheet to a calibration file.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

#include "sil/studies/identification/identification.hpp"

namespace sil {

// Removes from the folder, which is made if need be, what an earlier identification left.
void prepare_identification_folder(const std::filesystem::path& output);

// Writes calibration.toml and the reports, without pictures. Throws std::runtime_error when the component
// would refuse the calibration, which is then called calibration.refused.toml.
void write_identification(const Identification& result, const std::filesystem::path& output);

// Adds the subcommand `identify` to `app`.
void add_identify_command(CLI::App& app);

}  // namespace sil
