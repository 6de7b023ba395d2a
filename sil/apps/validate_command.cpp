#include "sil/apps/commands.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "sil/apps/identify_command.hpp"
#include "sil/apps/replay_command.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/file_io.hpp"
#include "sil/studies/drives/drive_csv.hpp"
#include "sil/studies/drives/drive_names.hpp"
#include "sil/studies/identification/calibration_writer.hpp"
#include "sil/studies/vehicle_validation/validation_folder.hpp"
#include "sil/studies/vehicle_validation/validation_page.hpp"

namespace sil {
namespace {

struct ValidateRequest {
    std::filesystem::path folder{};
    std::filesystem::path calibration{};  // empty: identified
    std::filesystem::path output{};
};

std::vector<Drive> read_drives(const std::vector<std::filesystem::path>& files) {
    std::vector<Drive> drives;
    for (const std::filesystem::path& file : files) {
        drives.push_back(read_drive_csv(file));
    }
    return drives;
}

// The calibration's file.
std::filesystem::path identify_into(const std::filesystem::path& output, const ValidationFolder& folder,
                                    const VehicleData& vehicle, Validation& validation) {
    if (folder.ramps.empty() || folder.dynamics.empty()) {
        throw std::runtime_error(
            "a slow ramp and a dynamic drive are both needed, files named ramp*.csv and dynamic*.csv; or "
            "give the "
            "calibration that is to be checked by --parameters");
    }
    fmt::print("Identifying, from {} ramps and {} dynamic drives\n", folder.ramps.size(),
               folder.dynamics.size());
    prepare_identification_folder(output);
    const Identification result = identify(vehicle, read_drives(folder.ramps), read_drives(folder.dynamics));
    write_identification(result, output);
    validation.warnings = result.warnings;
    validation.calibration = fmt::format(
        "It was identified from {} ramps and {} dynamic drives, which are not among these: "
        "identification/report.html.",
        folder.ramps.size(), folder.dynamics.size());
    return output / "calibration.toml";
}

// Results of an earlier validation must not be taken for those of this one, should it fail.
void prepare_validation_folder(const std::filesystem::path& output) {
    make_folder(output);
    for (const char* name : {"report.html", "drives.csv"}) {
        remove_file(output / name);
    }
}

void validate(const ValidateRequest& request) {
    prepare_validation_folder(request.output);
    const ValidationFolder folder = read_validation_folder(request.folder);
    const VehicleData vehicle = load_vehicle_data(folder.vehicle_data.string(), {});
    const std::vector<Drive> drives = read_drives(folder.checks);
    Validation validation;
    validation.vehicle = vehicle.name;
    std::filesystem::path calibration = request.calibration;
    if (calibration.empty()) {
        calibration = identify_into(request.output / "identification", folder, vehicle, validation);
    } else {
        validation.calibration = fmt::format("It is {}.", calibration.string());
        validation.warnings = doubts_in(read_whole_file(calibration));
    }
    const rsi::Parameters parameters = load_calibration(calibration.string());
    const std::vector<std::string> names = drive_names(folder.checks);
    make_folder(request.output / "comparisons");
    for (std::size_t place = 0U; place < drives.size(); ++place) {
        validation.comparisons.push_back(compare_drive(drives[place], vehicle, parameters));
        validation.comparisons.back().name = names[place];
        write_file_atomically(request.output / "comparisons" / (names[place] + ".csv"),
                              comparison_csv(validation.comparisons.back()));
    }
    ReplayRequest replay;
    replay.files = folder.checks;
    replay.parameters = calibration;
    replay.output = request.output / "replays";
    replay.without_pictures = true;
    validation.replays = run_replay(replay);
    write_file_atomically(request.output / "drives.csv", validation_csv(validation));
    write_file_atomically(request.output / "report.html", validation_page(validation));
    fmt::print("\nThe calibration against the drives:\n{}All of it is in {}\n", validation_text(validation),
               (request.output / "report.html").string());
}

}  // namespace

void add_validate_command(CLI::App& app) {
    const auto request = std::make_shared<ValidateRequest>();
    CLI::App* command = app.add_subcommand(
        "validate", "Calibrate a vehicle by some of its drives and compare the calibration with the others");
    command
        ->add_option("folder", request->folder,
                     "With vehicle.toml, ramp*.csv, dynamic*.csv and other drives (docs/calibration.md)")
        ->required();
    command->add_option("--parameters", request->calibration,
                        "Check this calibration (TOML), in place of one that is identified");
    command->add_option("--output", request->output, "Folder for the report, the calibration and the replays")
        ->required();
    command->callback([request] { validate(*request); });
}

}  // namespace sil
