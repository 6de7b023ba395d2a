// Procedure command: a test of a rule book on a simulated vehicle, with its verdict.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

// `rsi-sil procedure`.
void add_procedure_command(CLI::App& app);

}  // namespace sil
