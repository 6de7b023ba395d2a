// Subcommand `fault-search`.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

void add_fault_search_command(CLI::App& app);

}  // namespace sil
