// rsi-ecu: the firmware on SocketCAN, on a vehicle's can0 as well as on vcan0, and its replay of recorded
// frames.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "sil/apps/command_line.hpp"
#include "sil/apps/ecu_loop.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/candump_log.hpp"
#include "sil/files/file_io.hpp"
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

void run_loop(sil::EcuRequest& request, const std::string& parameters) {
    request.calibration_name = std::filesystem::path{parameters}.stem().string();
    std::signal(SIGTERM, request_end);
    std::signal(SIGINT, request_end);
    std::signal(SIGPIPE, SIG_IGN);  // keep running if the log's reader goes away
    sil::run_ecu(request, sil::load_calibration(parameters), end_requested);
}

void require_parameters(const std::string& parameters) {
    if (parameters.empty()) {
        throw sil::UsageError{
            "--parameters FILE is missing: the calibration of the component. The project has some in "
            "firmware/calibrations, for example firmware/calibrations/large_suv.toml"};
    }
}

std::vector<sil::LoggedFrame> answers_to(const ReplayRequest& request) {
    const sil::SiftedLog log = sil::sift_candump_log(sil::read_whole_file(request.log));
    sil::tell(log.left_out.text(request.log));
    const rsi::Parameters parameters = sil::load_calibration(request.parameters);
    try {
        return sil::replay(log.frames, parameters);
    } catch (const sil::ReplayError& error) {
        const std::string place = error.line() == 0U ? "" : fmt::format(":{}", error.line());
        throw std::runtime_error(fmt::format("{}{}: {}", request.log.string(), place, error.what()));
    }
}

void replay_log(const ReplayRequest& request) {
    std::error_code ignored;  // set when the output does not exist, as it should be
    if (std::filesystem::equivalent(request.log, request.output, ignored)) {
        throw sil::UsageError{
            fmt::format("--output {} is the log to replay, which would be lost; choose another name",
                        request.output.string())};
    }
    const std::vector<sil::LoggedFrame> answers = answers_to(request);
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
    CLI::Option* xcp = app.add_flag("--xcp", request.xcp, "Answer XCP on CAN (identifiers 0x6F0 and 0x6F1)");
    app.add_option("--xcp-storage", request.xcp_storage,
                   "Existing folder for what XCP stores; without it that is lost at the end")
        ->check(CLI::ExistingDirectory)
        ->needs(xcp);
    CLI::Option* diagnosis =
        app.add_flag("--diagnosis", request.diagnosis,
                     "Keep trouble codes and answer UDS on ISO-TP (identifiers 0x7A6, 0x7DF and 0x7AE)");
    app.add_option("--diagnosis-storage", request.diagnosis_storage,
                   "Existing folder for what diagnosis keeps; without it that is lost at the end")
        ->check(CLI::ExistingDirectory)
        ->needs(diagnosis);
    app.add_option(
           "--key", request.key,
           "Key file of XCP (TOML: calibration = \"32 hexadecimal digits\") and diagnosis (diagnosis = "
           "...); `test`: the public test keys")
        ->capture_default_str();
    app.add_flag("--receive-everything", request.receive_everything,
                 "Set no filters in the kernel, to show what a busy bus does without them");

    CLI::App* replayed =
        app.add_subcommand("replay", "Feed recorded sensor frames to the firmware in simulated time");
    replayed->add_option("log", replay.log, "Log written by `candump -L`")->required();
    replayed->add_option("--parameters", replay.parameters, "Calibration of the component (TOML)");
    replayed->add_option("--output", replay.output, "Log of the frames that the firmware sends")->required();

    return sil::run_program(app, [&] {
        app.parse(argc, argv);
        if (replayed->parsed()) {
            require_parameters(replay.parameters);
            replay_log(replay);
        } else {
            require_parameters(parameters);
            run_loop(request, parameters);
        }
    });
}
