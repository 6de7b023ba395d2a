#include "sil/apps/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "sil/apps/command_line.hpp"
#include "sil/apps/generated_page.hpp"
#include "sil/apps/vehicle_options.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/file_io.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/studies/campaign/settings.hpp"
#include "sil/studies/faults/endurance.hpp"
#include "sil/studies/faults/fault_matrix.hpp"
#include "sil/studies/faults/intermittent.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil {
namespace {

struct FaultsRequest {
    VehicleFiles files;
    GeneratedPage page;
};

void print_unexpected(const Scene& scene, const Injection& injection) {
    if (injection.verdict.shortfalls.empty()) {
        return;
    }
    fmt::print("{} | {} | {}, from {:.2f} s: {} ({})\n", describe(injection.fault),
               to_string(injection.fault.place), scene.name,
               static_cast<double>(scene.fault_begin) * cycle_time_s,
               fmt::join(injection.verdict.shortfalls, "; "), describe({injection.reaction}));
}

void print_unexpected(const FaultMatrix& matrix) {
    for (const FaultRow& row : matrix.rows) {
        for (const FaultCell& cell : row.cells) {
            for (const Injection& injection : cell) {
                print_unexpected(matrix.scenes[injection.scene], injection);
            }
        }
    }
}

void check_injections(const InjectionCount& count) {
    const std::size_t silenced = count.silenced - count.silenced_known_undetected;
    if (silenced > 0U) {
        throw std::runtime_error(fmt::format(
            "{} injections turn a due warning into \"ready\" without a diagnostic code, and are "
            "not stated in sil/studies/faults/known_undetected.cpp: see the lines with \"silent\" above",
            silenced));
    }
    const std::size_t otherwise = count.all - count.as_expected - count.known_undetected;
    if (otherwise > 0U) {
        throw std::runtime_error(
            fmt::format("{} injections are not answered as expected: see the lines above, "
                        "sil/studies/faults/expectation.cpp and sil/studies/faults/contradiction.cpp",
                        otherwise));
    }
}

void run_faults(const FaultsRequest& request) {
    const FaultMatrix matrix =
        run_fault_matrix(load_vehicle(request.files.vehicle), load_calibration(request.files.calibration));
    const std::string document = fault_matrix_document(matrix);
    const InjectionCount count = count_injections(matrix);
    print_unexpected(matrix);
    fmt::print(
        "{} injections of {} faults in {} scenes: {} as expected, of which {} were not visible; {} by "
        "errors that no check sees in time; due warnings silenced: {} of {}, of which {} by those\n",
        count.all, matrix.rows.size(), scene_count, count.as_expected, count.invisible,
        count.known_undetected, count.silenced, count.with_due_warning, count.silenced_known_undetected);
    check_injections(count);
    write_or_check(request.page, document, fault_matrix_data(matrix));
}

struct EnduranceRequest {
    VehicleFiles files;
    std::vector<double> hours;
    std::vector<std::uint64_t> seeds{1U};
    std::filesystem::path document;
    std::filesystem::path checked;
};

EnduranceResult run_with_progress(const EnduranceRequest& request, const EnduranceSettings& settings) {
    const auto progress = [&settings](double share) {
        tell(fmt::format("\r{:g} simulated hours, seed {}: {:3.0f} %", settings.hours, settings.seed,
                         share * 100.0));
    };
    const EnduranceResult result = run_endurance(
        load_vehicle(request.files.vehicle), load_calibration(request.files.calibration), settings, progress);
    progress(1.0);
    tell("\n");
    return result;
}

void run_hours(const EnduranceRequest& request) {
    std::string rows;
    std::vector<std::string> found;
    for (const double hours : request.hours) {
        for (const std::uint64_t seed : request.seeds) {
            const EnduranceSettings settings{hours, seed};
            const EnduranceResult result = run_with_progress(request, settings);
            rows += endurance_row(settings, result);
            const std::vector<std::string> more = shortfalls(result);
            found.insert(found.end(), more.begin(), more.end());
        }
    }
    const std::string document = endurance_document(rows);
    fmt::print("{}", rows);
    if (!request.document.empty()) {
        write_file_atomically(request.document, document);
    }
    if (!found.empty()) {
        throw std::runtime_error(fmt::format("not as it must be: {}", fmt::join(found, "; ")));
    }
    require_in_page(request.checked, rows, "rows", "sil/studies/faults/run --endurance");
}

void add_endurance(CLI::App& app) {
    const auto request = std::make_shared<EnduranceRequest>();
    CLI::App* command =
        app.add_subcommand("endurance", "Hours of mixed driving with random faults, in process");
    add_vehicle_options(*command, request->files);
    command->add_option("--hours", request->hours, "Simulated hours; repeated: one run after the other")
        ->required()
        ->allow_extra_args(false)
        ->check(number_within(0.01, 1000.0));
    add_whole_numbers(*command, "--seed", request->seeds,
                      "Seed of drive, noise and faults; repeated: each of --hours with each of them")
        ->default_str("1");
    command->add_option("--document", request->document, "Write the page with these runs");
    command->add_option("--check", request->checked, "A page that must hold these runs");
    command->callback([request] { run_hours(*request); });
}

struct IntermittentRequest {
    std::size_t sample{400U};
    std::filesystem::path document;
    std::filesystem::path checked;
};

std::vector<IntermittentRun> inject_bursts(std::size_t most_runs) {
    std::vector<IntermittentVehicle> vehicles;
    for (const CampaignVehicle& each : load_campaign("sil/studies/faults/search.toml").vehicles) {
        vehicles.push_back({std::filesystem::path{each.parameters}.stem().string(),
                            load_vehicle(each.parameters), load_calibration(each.calibration)});
    }
    const std::vector<IntermittentRun> runs = run_intermittent_faults(vehicles, most_runs, [](double share) {
        tell(fmt::format("\rbursts of every signal: {:3.0f} %", share * 100.0));
    });
    tell("\n");
    const std::vector<std::string> found = intermittent_shortfalls(runs);
    if (!found.empty()) {
        throw std::runtime_error(fmt::format("not as it must be: {}", fmt::join(found, "; ")));
    }
    return runs;
}

void run_intermittent(const IntermittentRequest& request) {
    const std::string sample = intermittent_row("sample", inject_bursts(request.sample));
    fmt::print("{}", sample);
    if (!request.document.empty()) {
        const std::vector<IntermittentRun> all = inject_bursts(0U);
        write_file_atomically(request.document,
                              intermittent_document(all, sample + intermittent_row("all", all)));
    }
    require_in_page(request.checked, sample, "figures", "sil/studies/faults/run --intermittent");
}

void add_intermittent(CLI::App& app) {
    const auto request = std::make_shared<IntermittentRequest>();
    CLI::App* command = app.add_subcommand(
        "intermittent-faults", "Bursts of an error in each signal, in everyday driving, in process");
    command->add_option("--sample", request->sample, "How many runs, evenly spread; 0: all")
        ->capture_default_str();
    command->add_option("--document", request->document, "Run all, and write the page");
    command->add_option("--check", request->checked, "A page that must hold the sample's row");
    command->callback([request] { run_intermittent(*request); });
}

}  // namespace

void add_faults_command(CLI::App& app) {
    const auto request = std::make_shared<FaultsRequest>();
    CLI::App* command =
        app.add_subcommand("faults", "Inject every fault into every scene and judge what the ECU does");
    add_vehicle_options(*command, request->files);
    add_page_options(*command, request->page);
    command->callback([request] { run_faults(*request); });
    add_endurance(app);
    add_intermittent(app);
}

}  // namespace sil
