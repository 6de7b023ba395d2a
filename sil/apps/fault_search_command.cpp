#include "sil/apps/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "sil/apps/command_line.hpp"
#include "sil/apps/generated_page.hpp"
#include "sil/apps/progress_line.hpp"
#include "sil/apps/stop_request.hpp"
#include "sil/files/file_io.hpp"
#include "sil/studies/faults/search_report.hpp"

namespace sil {
namespace {

struct FaultSearchRequest {
    std::filesystem::path settings{"sil/studies/faults/search.toml"};
    std::vector<std::uint64_t> scenarios{};
    std::uint64_t seed{1U};
    std::optional<std::uint64_t> single{};
    unsigned jobs{std::max(1U, std::thread::hardware_concurrency())};
    std::filesystem::path output{"fault_search"};
    std::filesystem::path document{};
    std::filesystem::path checked{};
};

CampaignSettings settings_of(const FaultSearchRequest& request, std::uint64_t scenarios) {
    CampaignSettings settings = load_campaign(request.settings);
    settings.runs = scenarios;
    settings.seed = request.seed;
    check_campaign(settings);
    return settings;
}

SearchReport search(const FaultSearchRequest& request, std::uint64_t scenarios) {
    const FaultSearch search{settings_of(request, scenarios)};
    const std::filesystem::path folder = request.output / fmt::format("{}-{}", scenarios, request.seed);
    ProgressLine line{[](const RowProgress& now, double rate, double left_s) {
        return fmt::format("{} of {} scenarios, {:.0f} a second, {:.0f} s left", now.finished, now.total,
                           rate, left_s);
    }};
    const RowProgress progress = run_fault_search(search, folder, request.jobs, stop_on_signals(),
                                                  [&line](const RowProgress& now) { line.show(now); });
    require_finished(progress, "scenarios", folder);
    return report_on(load_search(folder), request.seed);
}

void fail_if_any(const std::vector<std::string>& found, const char* what) {
    for (const std::string& each : found) {
        fmt::print("{}: {}\n", what, each);
    }
    if (!found.empty()) {
        throw std::runtime_error(
            "the findings are not those of sil/studies/faults/known_findings.toml: see the lines above");
    }
}

// A search that makes the page is long enough to find all that is known by searches alone.
void run_searches(const FaultSearchRequest& request) {
    std::vector<SearchReport> reports;
    std::string sections;
    std::vector<std::string> unknown;
    for (const std::uint64_t scenarios : request.scenarios) {
        reports.push_back(search(request, scenarios));
        sections += search_section(reports.back());
        const std::vector<std::string> more = unknown_findings(reports.back());
        unknown.insert(unknown.end(), more.begin(), more.end());
    }
    fmt::print("{}", sections);
    fail_if_any(unknown, "not known");
    if (!request.document.empty()) {
        fail_if_any(vanished_findings(reports), "known, but no longer found");
        write_file_atomically(request.document, search_document(sections));
    }
    require_in_page(request.checked, sections, "figures", "sil/studies/faults/run --search");
}

void run_search(const FaultSearchRequest& request) {
    if (request.single) {
        fmt::print("{}", FaultSearch{settings_of(request, 1U)}.explain(*request.single));
        return;
    }
    if (request.scenarios.empty()) {
        throw CLI::RequiredError{"--scenarios or --scenario"};
    }
    run_searches(request);
}

}  // namespace

void add_fault_search_command(CLI::App& app) {
    const auto request = std::make_shared<FaultSearchRequest>();
    CLI::App* command = app.add_subcommand(
        "fault-search",
        "Random faults in random drives: is a due warning missed, or a false one given, silently?");
    command->add_option("--settings", request->settings, "Distributions that drives are drawn from (TOML)")
        ->capture_default_str();
    CLI::Option* scenarios = add_whole_numbers(*command, "--scenarios", request->scenarios,
                                               "How many; repeated: one search after the other");
    add_whole_number(*command, "--seed", request->seed, "Seed of everything drawn")->default_str("1");
    add_whole_number(*command, "--scenario", request->single,
                     "No search: run the scenario of this number and say what happens")
        ->excludes(scenarios);
    command->add_option("--jobs", request->jobs, "Threads")
        ->check(CLI::Range(1U, 1024U))
        ->capture_default_str();
    command->add_option("--output", request->output, "Folder of the rows; taken up where it was left")
        ->capture_default_str();
    command->add_option("--document", request->document, "Write the page with these searches");
    command->add_option("--check", request->checked, "A page that must hold these searches");
    command->callback([request] { run_search(*request); });
}

}  // namespace sil
