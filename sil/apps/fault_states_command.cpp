#include "sil/apps/commands.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "sil/apps/generated_page.hpp"
#include "sil/apps/vehicle_options.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/studies/faults/state_matrix.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil {
namespace {

struct FaultStatesRequest {
    VehicleFiles files;
    GeneratedPage page;
};

void run_fault_states(const FaultStatesRequest& request) {
    const StateMatrix matrix =
        run_state_matrix(load_vehicle(request.files.vehicle), load_calibration(request.files.calibration));
    const std::vector<CellFinding> found = findings_in(matrix);
    const std::vector<std::string> unexpected = differences(found);
    for (const std::string& each : unexpected) {
        fmt::print("{}\n", each);
    }
    fmt::print("{} findings; {} differ from sil/studies/faults/known_findings.toml\n", found.size(),
               unexpected.size());
    if (!unexpected.empty()) {
        throw std::runtime_error(
            "the findings are not those of sil/studies/faults/known_findings.toml: see the lines above");
    }
    write_or_check(request.page, state_matrix_document(matrix), state_matrix_data(matrix));
}

}  // namespace

void add_fault_states_command(CLI::App& app) {
    const auto request = std::make_shared<FaultStatesRequest>();
    CLI::App* command = app.add_subcommand(
        "fault-states", "Inject every fault in every state of driving, and try every kind of good sensor");
    add_vehicle_options(*command, request->files);
    add_page_options(*command, request->page);
    command->callback([request] { run_fault_states(*request); });
}

}  // namespace sil
