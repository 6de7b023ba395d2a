// Replay command: recorded drives through the firmware, from request to results.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "sil/studies/drives/replay_table.hpp"

namespace sil {

struct ReplayRequest {
    std::vector<std::filesystem::path> files;  // CSV drives and candump logs
    std::filesystem::path parameters;
    std::vector<std::string> changes;  // of the parameters, as "key=value"
    std::filesystem::path output;
    bool without_pictures{false};
};

// The subcommand; `request` must live as long as `app`.
void add_replay_command(CLI::App& app, ReplayRequest& request);

// Writes OUTPUT/DRIVE/ for every file and OUTPUT/table.csv, prints progress and the table. A file that cannot
// be replayed leaves no folder; the others are replayed all the same. Throws std::exception with a message
// for the user, at the end also when files failed. Gives back the table, a row a file.
std::vector<ReplayRow> run_replay(const ReplayRequest& request);

}  // namespace sil
