#include "sil/apps/population_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "sil/apps/command_line.hpp"
#include "sil/studies/population/population.hpp"

namespace sil {
namespace {

std::atomic<bool> population_stop_requested{false};

void request_population_stop(int) {
    population_stop_requested = true;
}

// A line on stderr: over and over on a terminal, now and then in a log.
class VehicleProgressLine {
 public:
    void show(const RowProgress& progress) {
        const bool last = progress.finished == progress.total;
        if (!last && progress.elapsed_s < next_s_) {
            return;
        }
        next_s_ = progress.elapsed_s + (terminal_ ? 0.5 : 10.0);
        const double rate = static_cast<double>(progress.finished - progress.begun_with) / progress.elapsed_s;
        fmt::print(stderr, "{}{} of {} vehicles, {:.2f} a second, {:.0f} s left{}", terminal_ ? "\r" : "",
                   progress.finished, progress.total, rate,
                   static_cast<double>(progress.total - progress.finished) / rate,
                   terminal_ && !last ? "      " : "\n");
    }

 private:
    const bool terminal_{::isatty(STDERR_FILENO) == 1};
    double next_s_{0.0};
};

void make(const PopulationRequest& request) {
    std::signal(SIGINT, request_population_stop);
    std::signal(SIGTERM, request_population_stop);
    VehicleProgressLine line;
    const RowProgress progress = make_population(request, population_stop_requested,
                                                 [&line](const RowProgress& now) { line.show(now); });
    if (progress.finished < progress.total) {
        throw std::runtime_error(fmt::format(
            "interrupted after {} of {} vehicles, which are kept in {}. The same command goes on from there.",
            progress.finished, progress.total, request.output.string()));
    }
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
    const auto add_whole_number = [command](const char* name, std::uint64_t& value, const char* description) {
        // Not CLI11's own conversion, which takes 010 for eight.
        command
            ->add_option_function<std::string>(
                name, [&value](const std::string& text) { value = whole_number(text).value_or(value); },
                description)
            ->check(check_whole_number)
            ->type_name("UINT")
            ->default_str(fmt::format("{}", value));
    };
    add_whole_number("--vehicles", request->vehicles, "How many; may grow later");
    add_whole_number("--seed", request->seed, "Seed of everything drawn");
    command->add_option("--output", request->output, "Folder of the vehicles; taken up where it was left")
        ->capture_default_str();
    command->add_option("--jobs", request->jobs, "Threads")
        ->check(CLI::Range(1U, 1024U))
        ->capture_default_str();
    command->callback([request] { make(*request); });
}

}  // namespace sil
