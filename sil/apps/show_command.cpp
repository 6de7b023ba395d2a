#include "sil/apps/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sil/apps/command_line.hpp"
#include "sil/apps/stop_request.hpp"
#include "sil/files/file_io.hpp"
#include "sil/input_error.hpp"
#include "sil/live/live_server.hpp"
#include "sil/page/page_text.hpp"

namespace sil {
namespace {

constexpr const char* page_name = "report.html";

struct ShowRequest {
    std::filesystem::path folder{};
    std::uint64_t port{0U};
};

// The folders below in which there is a page, for a message.
std::string pages_below(const std::filesystem::path& folder) {
    constexpr std::size_t most_named = 10U;
    std::vector<std::string> found;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator{folder, error}) {
        if (std::filesystem::exists(entry.path() / page_name, error)) {
            found.push_back(entry.path().string());
        }
    }
    std::sort(found.begin(), found.end());
    std::string names;
    for (std::size_t place = 0U; place < std::min(found.size(), most_named); ++place) {
        names += (names.empty() ? "" : ", ") + found[place];
    }
    return names + (found.size() > most_named ? fmt::format(" and {} more", found.size() - most_named) : "");
}

// Only the recording of the page is used: it is shown by the page of this program.
std::string recording_of(const std::filesystem::path& folder) {
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error)) {
        throw InputError(fmt::format(
            "{} is no folder; give the one of a run, or of a replayed drive (rsi-sil replay DRIVE makes one)",
            folder.string()));
    }
    const std::filesystem::path file = folder / page_name;
    if (!std::filesystem::exists(file, error)) {
        const std::string below = pages_below(folder);
        throw InputError(fmt::format(
            "{}: there is no {}; {}", folder.string(), page_name,
            below.empty() ? "a run or a replay of this version leaves one" : "choose one of " + below));
    }
    const std::string recording = recording_in(read_whole_file(file));
    if (recording.empty()) {
        throw InputError(
            fmt::format("{} holds no run that could be played; if it is the report of a study, open the file "
                        "itself in a browser",
                        file.string()));
    }
    const nlohmann::json json = nlohmann::json::parse(recording, nullptr, false);
    if (!json.is_object() || !json.contains("columns") || !json.contains("rows") ||
        !json.contains("vehicle")) {
        throw InputError(fmt::format(
            "{} is damaged: its recording cannot be read; make the run or the replay again", file.string()));
    }
    return recording;
}

void show(const ShowRequest& request) {
    const std::atomic<bool>& stop = stop_on_signals();
    const std::string page = page_with(recording_of(request.folder));
    serve_page(page, static_cast<std::uint16_t>(request.port), stop, [&request](std::uint16_t port) {
        fmt::print("Open http://127.0.0.1:{}/ in a browser of this machine: {}. Ctrl-C ends it.\n", port,
                   request.folder.string());
        std::fflush(stdout);
    });
}

}  // namespace

void add_show_command(CLI::App& app) {
    const auto request = std::make_shared<ShowRequest>();
    CLI::App* command = app.add_subcommand(
        "show",
        "Play a finished run or a replayed drive in a browser. Serves one page, to this machine only");
    command->add_option("folder", request->folder, "That a run, or a replay for one drive, has left")
        ->required();
    add_port_option(*command, request->port);
    command->callback([request] { show(*request); });
}

}  // namespace sil
