#include "sil/apps/commands.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "sil/apps/command_line.hpp"
#include "sil/apps/vehicle_options.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/studies/faults/memory_flips.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil {
namespace {

struct MemoryFlipsRequest {
    VehicleFiles files;
    std::uint64_t flips{10000U};
    std::uint64_t seed{1U};
    double most_silent{1000.0};
};

void require_few(const FlipCount& count, double most_of_1000, const char* whose) {
    if (1000.0 * static_cast<double>(silent(count)) > most_of_1000 * static_cast<double>(total(count))) {
        throw std::runtime_error(
            fmt::format("{} of {} flips in the memory of {} make a warning silently late, missing or false",
                        silent(count), total(count), whose));
    }
}

void run(const MemoryFlipsRequest& request) {
    const MemoryFlips result =
        run_memory_flips(load_vehicle(request.files.vehicle), load_calibration(request.files.calibration),
                         request.flips, request.seed);
    fmt::print("{}{}", memory_flips_table(result), silent_flips(result));
    require_few(count_component_flips(result), request.most_silent, "the component");
    require_few(count_flips(result), request.most_silent, "the ECU");
}

}  // namespace

void add_memory_flips_command(CLI::App& app) {
    const auto request = std::make_shared<MemoryFlipsRequest>();
    CLI::App* command = app.add_subcommand(
        "memory-flips", "Change single bits of the ECU's memory and judge what becomes of the warning");
    add_vehicle_options(*command, request->files);
    add_whole_number(*command, "--flips", request->flips, "How many")
        ->default_str(fmt::format("{}", request->flips));
    add_whole_number(*command, "--seed", request->seed, "Seed of drive, moment and bit")
        ->default_str(fmt::format("{}", request->seed));
    command
        ->add_option("--most-silent", request->most_silent,
                     "Largest number of silently late, missing or false warnings in 1,000 flips")
        ->check(number_within(0.0, 1000.0));
    command->callback([request] { run(*request); });
}

}  // namespace sil
