// Validate command: from a folder of a vehicle's drives to a report on its calibration.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

void add_validate_command(CLI::App& app);

}  // namespace sil
