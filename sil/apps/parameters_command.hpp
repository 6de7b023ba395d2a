// Parameters command: from a calibration file to the parameter section of an image, and back.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

// Adds the subcommand `parameters` to `app`.
void add_parameters_command(CLI::App& app);

}  // namespace sil
