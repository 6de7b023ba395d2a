#include "sil/apps/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "sil/apps/command_line.hpp"
#include "sil/apps/progress_line.hpp"
#include "sil/apps/stop_request.hpp"
#include "sil/studies/population/population.hpp"

namespace sil {
namespace {

void make(const PopulationRequest& request) {
    const std::atomic<bool>& stop = stop_on_signals();
    ProgressLine line{[](const RowProgress& now, double rate, double left_s) {
        return fmt::format("{} of {} vehicles, {:.2f} a second, {:.0f} s left", now.finished, now.total, rate,
                           left_s);
    }};
    const RowProgress progress =
        make_population(request, stop, [&line](const RowProgress& now) { line.show(now); });
    require_finished(progress, "vehicles", request.output);
    fmt::print("{}", describe_population(request.output));
}

}  // namespace

void add_population_command(CLI::App& app) {
    const auto request = std::make_shared<PopulationRequest>();
    request->output = "output/population";
    request->jobs = std::max(1U, std::thread::hardware_concurrency());
    CLI::App* command = app.add_subcommand("population",
                                           "Draw plausible vehicles of many classes, calibrate each by "
                                           "identify alone, and write the settings of campaigns "
                                           "on either half of them");
    add_whole_number(*command, "--vehicles", request->vehicles, "How many; may grow later")
        ->default_str(fmt::format("{}", request->vehicles));
    add_whole_number(*command, "--seed", request->seed, "Seed of everything drawn")
        ->default_str(fmt::format("{}", request->seed));
    command->add_flag("--only-report", request->only_report,
                      "All vehicles are to report on, none to choose on");
    command->add_option("--output", request->output, "Folder of the vehicles; taken up where it was left")
        ->capture_default_str();
    command->add_option("--jobs", request->jobs, "Threads")
        ->check(CLI::Range(1U, 1024U))
        ->capture_default_str();
    command->callback([request] { make(*request); });
}

}  // namespace sil
