// Show command: a finished run, or a replayed drive, in a browser.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

void add_show_command(CLI::App& app);

}  // namespace sil
