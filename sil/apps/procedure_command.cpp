#include "sil/apps/commands.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "sil/apps/command_line.hpp"
#include "sil/apps/vehicle_options.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/studies/procedures/catalogue.hpp"
#include "sil/studies/procedures/procedure_files.hpp"
#include "sil/studies/procedures/procedure_text.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil {
namespace {

struct ProcedureRequest {
    std::string name{};
    VehicleFiles files{};
    std::filesystem::path output{};
    bool signals{false};
};

void list_procedures() {
    for (const Procedure& procedure : all_procedures()) {
        fmt::print("{:<16} {}\n{:<16} after {}\n", procedure.name, procedure.description, "",
                   fmt::join(procedure.sources, "; "));
    }
}

Procedure find(const std::string& name) {
    try {
        return find_procedure(name);
    } catch (const UnknownProcedure& error) {
        throw UsageError{error.what()};
    }
}

void run_procedure(const ProcedureRequest& request) {
    const Procedure procedure = find(request.name);
    ProcedureWorld world;
    world.vehicle = load_vehicle(request.files.vehicle);
    world.calibration = load_calibration(request.files.calibration);
    if (request.signals) {
        world.signals = request.output;
    }
    world.finished_step = [](const ProcedureStep& step) {
        fmt::print("{}", step_text(step));
        std::fflush(stdout);
    };
    if (!request.output.empty()) {
        prepare_procedure_folder(request.output);
    }
    fmt::print("{}", head_text(procedure, world.vehicle));
    const ProcedureResult result = procedure.run(world);
    fmt::print("{}", result_text(result));
    if (!request.output.empty()) {
        write_procedure(procedure, world.vehicle.name, result, request.output);
    }
}

}  // namespace

void add_procedure_command(CLI::App& app) {
    const auto request = std::make_shared<ProcedureRequest>();
    CLI::App* command = app.add_subcommand("procedure",
                                           "Run a test of a rule book as written and print its verdict, with "
                                           "the ECU's warning beside it. A vehicle "
                                           "that does not meet it is no error");
    CLI::Option* name =
        command->add_option("procedure", request->name, "Its name; `rsi-sil procedure --list` names all");
    CLI::Option* vehicle = command->add_option("--vehicle", request->files.vehicle,
                                               "Parameter file of the simulated vehicle (TOML)");
    CLI::Option* parameters =
        command->add_option("--parameters", request->files.calibration, "Calibration of the firmware (TOML)");
    CLI::Option* output =
        command->add_option("--output", request->output, "Folder for result.json and steps.csv");
    command
        ->add_flag("--signals", request->signals,
                   "Leave a folder for each step, too, of which sil/results/draw makes pictures")
        ->needs(output);
    CLI::Option* list = command->add_flag("--list", "Name all procedures with their sources");
    list->excludes(name);
    command->callback([request, name, vehicle, parameters, list] {
        if (*list) {
            list_procedures();
            return;
        }
        if (!*name || !*vehicle || !*parameters) {
            throw CLI::RequiredError("a procedure's name with --vehicle and --parameters, or --list,");
        }
        run_procedure(*request);
    });
}

}  // namespace sil
