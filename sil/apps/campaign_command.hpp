// Campaign command: a Monte Carlo campaign from the command line, with its progress.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

// Adds the subcommand `campaign` to rsi-sil; its callback throws std::exception with a message for the user.
void add_campaign(CLI::App& app);

}  // namespace sil
