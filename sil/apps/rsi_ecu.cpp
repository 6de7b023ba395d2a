// rsi-ecu: the firmware on SocketCAN, on a vehicle's can0 as well as on vcan0, and its replay of recorded
// frames.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "sil/analysis/candump_log.hpp"
#include "sil/apps/ecu_loop.hpp"
#include "sil/calibration/calibration_file.hpp"
#include "sil/simulation/replay.hpp"

namespace {

struct ReplayRequest {
    std::string parameters;
    std::filesystem::path log;
    std::filesystem::path output;
};

// A handler may only set this; the loop looks at it once a cycle.
volatile std::sig_atomic_t end_requested = 0;

void request_end(int) {
    end_requested = 1;
}

void run_loop(const sil::EcuRequest& request, const std::string& parameters) {
    std::signal(SIGTERM, request_end);
    std::signal(SIGINT, request_end);
    sil::run_ecu(request, sil::load_calibration(parameters), end_requested);
}

void replay_log(const ReplayRequest& request) {
    const std::vector<sil::LoggedFrame> answers =
        sil::replay(sil::read_candump_log(request.log), sil::load_calibration(request.parameters));
    sil::CandumpLogWriter writer{request.output};
    for (const sil::LoggedFrame& answer : answers) {
        writer.write(answer);
    }
    writer.close();
    fmt::print("{} frames written to {}\n", answers.size(), request.output.string());
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"The rollover-warning firmware on a CAN interface", "rsi-ecu"};
    app.failure_message(CLI::FailureMessage::help);
    sil::EcuRequest request;
    std::string parameters;
    ReplayRequest replay;
    app.add_option("--interface", request.interface, "CAN interface")->capture_default_str();
    app.add_option("--parameters", parameters, "Calibration of the component (TOML)");
    app.add_flag("--lock-step", request.lock_step,
                 "Step when a SimulationSync frame says so, in simulated time");
    app.add_option("--priority", request.fifo_priority, "Real-time priority under SCHED_FIFO")
        ->check(CLI::Range(1, 99));
    app.add_flag("--lock-memory", request.lock_memory, "Keep all memory from being paged out");

    CLI::App* replayed =
        app.add_subcommand("replay", "Feed recorded sensor frames to the firmware in simulated time");
    replayed->add_option("log", replay.log, "Log written by `candump -L`")->required();
    replayed->add_option("--parameters", replay.parameters, "Calibration of the component (TOML)")
        ->required();
    replayed->add_option("--output", replay.output, "Log of the frames that the firmware sends")->required();

    try {
        app.parse(argc, argv);
        if (replayed->parsed()) {
            replay_log(replay);
        } else if (parameters.empty()) {
            throw CLI::RequiredError("--parameters");
        } else {
            run_loop(request, parameters);
        }
        return 0;
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    } catch (const std::exception& error) {
        fmt::print(stderr, "rsi-ecu: {}\n", error.what());
        return 1;
    }
}
