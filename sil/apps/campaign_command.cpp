#include "sil/apps/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "sil/apps/command_line.hpp"
#include "sil/apps/progress_line.hpp"
#include "sil/apps/single_run.hpp"
#include "sil/apps/stop_request.hpp"
#include "sil/files/file_io.hpp"
#include "sil/studies/campaign/campaign.hpp"
#include "sil/studies/campaign/campaign_folder.hpp"
#include "sil/studies/campaign/campaign_page.hpp"
#include "sil/studies/campaign/campaign_part.hpp"
#include "sil/studies/campaign/report.hpp"
#include "sil/studies/campaign/settings.hpp"

namespace sil {
namespace {

struct CampaignRequest {
    std::string settings_file;
    std::optional<std::uint64_t> runs;
    std::optional<std::uint64_t> seed;
    std::vector<std::string> vehicles;
    std::vector<std::string> changes;
    std::filesystem::path output{"output/campaign"};
    unsigned jobs{std::max(1U, std::thread::hardware_concurrency())};
    bool with_traces{false};
    std::uint64_t number{0U};  // of a single run
    std::uint64_t first{0U};   // of a part
    std::uint64_t count{0U};
};

CampaignSettings settings_of(const CampaignRequest& request) {
    CampaignSettings settings =
        request.settings_file.empty() ? default_campaign() : load_campaign(request.settings_file);
    settings.runs = request.runs.value_or(settings.runs);
    settings.seed = request.seed.value_or(settings.seed);
    if (!request.vehicles.empty()) {
        settings.vehicles.clear();
        for (const std::string& vehicle : request.vehicles) {
            settings.vehicles.push_back(parse_campaign_vehicle(vehicle));
        }
    }
    settings.changes.insert(settings.changes.end(), request.changes.begin(), request.changes.end());
    for (CampaignVehicle& vehicle : settings.vehicles) {  // the folder's campaign.toml is read from anywhere
        vehicle.parameters = std::filesystem::absolute(vehicle.parameters).lexically_normal().string();
        vehicle.calibration = std::filesystem::absolute(vehicle.calibration).lexically_normal().string();
    }
    check_campaign(settings);
    return settings;
}

std::string duration(double seconds) {
    const auto whole = static_cast<long>(seconds + 0.5);
    return whole < 120 ? fmt::format("{} s", whole) : fmt::format("{} min {:02} s", whole / 60, whole % 60);
}

// By its absolute path; by its name alone if the system does not provide the path.
std::filesystem::path this_program() {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? std::filesystem::path{"rsi-sil"} : program;
}

void report(const CampaignRequest& request) {
    const std::filesystem::path settings = request.output / "campaign.toml";
    if (!std::filesystem::exists(settings)) {
        throw std::runtime_error(
            fmt::format("there is no campaign in {0}; `rsi-sil campaign run --output {0}` makes one",
                        request.output.string()));
    }
    const std::uint64_t wanted = load_campaign(settings).runs;
    const RowTable rows = load_campaign_rows(request.output);
    const CampaignReport report = make_report(rows, wanted);
    write_report(report, request.output);
    const CampaignCall call{this_program(), std::filesystem::current_path(), request.output};
    write_file_atomically(request.output / "report.html", campaign_page(report, rows, call));
    fmt::print(
        "{}\nAll of it is in {}, to look into in {}; sil/studies/campaign/draw {} makes the "
        "pictures.\n",
        report_markdown(report), (request.output / "report.json").string(),
        (request.output / "report.html").string(), request.output.string());
}

ProgressLine progress_line(unsigned jobs) {
    return ProgressLine{[jobs](const RowProgress& now, double rate, double left_s) {
        return fmt::format("{} of {} runs, {:.1f} runs/s, {:.0f} times real time a thread, {} left",
                           now.finished, now.total, rate, now.simulated_s / now.elapsed_s / jobs,
                           duration(left_s));
    }};
}

void run(const CampaignRequest& request) {
    const CampaignWorld world{settings_of(request)};
    const std::atomic<bool>& stop = stop_on_signals();
    ProgressLine line = progress_line(request.jobs);
    const RowProgress progress = run_campaign(
        world, request.output, request.jobs, stop, [&line](const RowProgress& now) { line.show(now); },
        request.with_traces);
    require_finished(progress, "runs", request.output);
    report(request);
}

void run_part(const CampaignRequest& request) {
    const CampaignWorld world{settings_of(request)};
    const std::atomic<bool>& stop = stop_on_signals();
    ProgressLine line = progress_line(request.jobs);
    const RowProgress progress = make_part(world, request.first, request.count, request.output, request.jobs,
                                           stop, [&line](const RowProgress& now) { line.show(now); });
    if (progress.finished < progress.total) {
        throw std::runtime_error(fmt::format(
            "interrupted after {} of {} runs; there is no part {}. The same command makes all of it.",
            progress.finished, progress.total, request.output.string()));
    }
    fmt::print("{} {}: runs {} to {}\n", request.output.string(),
               progress.begun_with == progress.total ? "was there already" : "is there", request.first,
               request.first + request.count - 1U);
}

void run_one(const CampaignRequest& request) {
    const std::filesystem::path output = request.output / fmt::format("run-{}", request.number);
    const CampaignRow row = drive_single_run(CampaignWorld{settings_of(request)}, request.number, output);
    write_file_atomically(output / "row.csv", row_header() + "\n" + row_line(row) + "\n");
    fmt::print("All of it is in {0}; sil/results/draw {0} makes the pictures.\n", output.string());
}

void begin(const CampaignRequest& request) {
    const CampaignWorld world{settings_of(request)};
    begin_campaign_folder(request.output, world.settings());
}

void check(const CampaignRequest& request) {
    fmt::print("{} rows are as they were written\n", load_campaign_rows(request.output).runs.size());
}

void add_settings(CLI::App& command, CampaignRequest& request) {
    command.add_option("--settings", request.settings_file,
                       "What to draw from (TOML; default: sil/studies/campaign/default.toml, built in)");
    add_whole_number(command, "--runs", request.runs, "How many runs (default: the settings')");
    add_whole_number(command, "--seed", request.seed, "Seed of everything drawn (default: the settings')");
    command.add_option("--vehicle", request.vehicles,
                       "VEHICLE_FILE:CALIBRATION_FILE, instead of the settings' vehicles; may be repeated");
    command
        .add_option("--set", request.changes,
                    "KEY=VALUE in place of what every calibration says; may be repeated")
        ->allow_extra_args(false);
}

CLI::Option* add_output(CLI::App& command, CampaignRequest& request, const std::string& description) {
    return command.add_option("--output", request.output, description);
}

void add_jobs(CLI::App& command, CampaignRequest& request) {
    command.add_option("--jobs", request.jobs, "Threads")
        ->check(CLI::Range(1U, 1024U))
        ->capture_default_str();
}

// Until version 0.2 the subcommands were options of `campaign` itself.
std::string subcommand_instead_of(const std::vector<std::string>& arguments) {
    const std::vector<std::pair<std::string, std::string>> options{{"--columns", "columns"},
                                                                   {"--begin", "begin"},
                                                                   {"--first", "part"},
                                                                   {"--run", "one NUMBER"},
                                                                   {"--report-only", "report"}};
    const auto given = std::find_if(options.begin(), options.end(), [&arguments](const auto& option) {
        return std::any_of(arguments.begin(), arguments.end(), [&option](const std::string& argument) {
            return argument == option.first || argument.rfind(option.first + "=", 0U) == 0U;
        });
    });
    return given == options.end() ? "run" : given->second;
}

// After its subcommands have been added, which would inherit that anything is allowed.
void refuse_options_of_its_own(CLI::App& campaign) {
    campaign.require_subcommand(0, 1)->allow_extras()->parse_complete_callback([&campaign] {
        if (campaign.get_subcommands().empty() || !campaign.remaining().empty()) {
            throw UsageError(fmt::format(
                "`campaign` is followed by run, report, check, one, part, begin or columns, and by its "
                "options then: here by `rsi-sil campaign {} ...`",
                subcommand_instead_of(campaign.remaining())));
        }
    });
}

}  // namespace

void add_campaign(CLI::App& app) {
    const auto request = std::make_shared<CampaignRequest>();
    CLI::App* const campaign = app.add_subcommand(
        "campaign",
        "Monte Carlo: many drawn runs in this process, one row each, and a report on all indices");
    CLI::App* const all = campaign->add_subcommand("run", "Drive all runs, and report on them");
    add_settings(*all, *request);
    add_output(*all, *request, "Folder of the rows; taken up where it was left")->capture_default_str();
    add_jobs(*all, *request);
    all->add_flag("--traces", request->with_traces,
                  "Every run also leaves its trace, OUTPUT/traces/NUMBER.csv, and its calibration");
    all->callback([request] { run(*request); });

    CLI::App* const again = campaign->add_subcommand("report", "Report on the rows that are there");
    add_output(*again, *request, "Folder of the rows")->capture_default_str();
    again->callback([request] { report(*request); });

    CLI::App* const checked = campaign->add_subcommand(
        "check", "Refuse rows that are not as they were written, or of another campaign");
    add_output(*checked, *request, "Folder of the rows")->capture_default_str();
    checked->callback([request] { check(*request); });

    CLI::App* const one =
        campaign->add_subcommand("one", "Drive the run of one number once more, into OUTPUT/run-NUMBER");
    add_whole_number(*one, "number", request->number, "Number of the run")->required();
    add_settings(*one, *request);
    add_output(*one, *request, "Folder of the campaign")->capture_default_str();
    one->callback([request] { run_one(*request); });

    CLI::App* const part = campaign->add_subcommand(
        "part", "A part of a campaign, for many machines: COUNT runs from FIRST on, into the file OUTPUT");
    add_whole_number(*part, "--first", request->first, "Number of the first run")->required();
    add_whole_number(*part, "--count", request->count, "How many runs the part has")->required();
    add_settings(*part, *request);
    add_output(*part, *request, "File of the part's rows")->required();
    add_jobs(*part, *request);
    part->callback([request] { run_part(*request); });

    CLI::App* const folder = campaign->add_subcommand(
        "begin", "The folder OUTPUT with its campaign.toml, from which parts are made");
    add_settings(*folder, *request);
    add_output(*folder, *request, "Folder of the campaign")->capture_default_str();
    folder->callback([request] { begin(*request); });

    campaign->add_subcommand("columns", "Names, units and meanings of the rows' columns, as JSON")
        ->callback([] { fmt::print("{}", row_columns_json()); });
    refuse_options_of_its_own(*campaign);
}

}  // namespace sil
