// Watch command: a live drive in a browser.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

// `watch [MANOEUVRE]`: serves the page until it is ended, and leaves what a run leaves of the last drive.
void add_watch_command(CLI::App& app);

}  // namespace sil
