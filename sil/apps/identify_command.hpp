// Identify command: from test drives and a data sheet to a calibration file.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

// Adds the subcommand `identify` to `app`.
void add_identify_command(CLI::App& app);

}  // namespace sil
