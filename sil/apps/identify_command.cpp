#include "sil/apps/identify_command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "sil/apps/command_line.hpp"
#include "sil/apps/drawing_script.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/file_io.hpp"
#include "sil/studies/drives/drive_csv.hpp"
#include "sil/studies/identification/calibration_writer.hpp"
#include "sil/studies/identification/identification.hpp"
#include "sil/studies/identification/identification_page.hpp"
#include "sil/studies/identification/report.hpp"
#include "sil/studies/identification/simulated_drive.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil {
namespace {

struct IdentifyRequest {
    std::string vehicle_data;
    std::vector<std::string> settings;
    std::vector<std::string> ramps;
    std::vector<std::string> dynamics;
    std::filesystem::path output;
    double until_s{1.0e9};
    bool keep_cg_height{false};
    std::string simulated_vehicle;
    SensorFlaws sensors;
    bool no_pictures{false};
};

// Two drives of a simulated vehicle, left behind as the CSV files that they are read from.
void simulate_drives(IdentifyRequest& request) {
    const VehicleParameters vehicle = load_vehicle(request.simulated_vehicle);
    const std::filesystem::path folder = request.output / "drives";
    make_folder(folder);
    const auto drive = [&](const char* manoeuvre, std::vector<std::string>& files) {
        const std::filesystem::path file = folder / (std::string{manoeuvre} + ".csv");
        write_file_atomically(file,
                              drive_csv(simulate_drive(vehicle, find_manoeuvre(manoeuvre), request.sensors)));
        files.push_back(file.string());
        ++request.sensors.seed;
    };
    drive("slow-ramp", request.ramps);
    drive("step-steer", request.dynamics);
}

void refuse_unclear(const IdentifyRequest& request) {
    const bool drives = !request.ramps.empty() || !request.dynamics.empty();
    if (!request.simulated_vehicle.empty() && drives) {
        throw std::runtime_error(
            "--simulate makes drives of its own: leave --ramp and --dynamic out, or --simulate");
    }
    if (request.simulated_vehicle.empty() && (request.ramps.empty() || request.dynamics.empty())) {
        throw std::runtime_error(
            "a slow ramp and a dynamic drive are both needed: give --ramp FILE and --dynamic FILE "
            "(docs/calibration.md "
            "says how to drive them), or --simulate VEHICLE.toml");
    }
    if (request.vehicle_data.empty() && request.settings.empty()) {
        throw std::runtime_error(
            "nothing is said of the vehicle: give --vehicle-data FILE (docs/calibration.md)");
    }
}

std::vector<Drive> read_all(const std::vector<std::string>& files) {
    std::vector<Drive> drives;
    for (const std::string& file : files) {
        drives.push_back(read_drive_csv(file));
    }
    return drives;
}

// Without pictures the calibration is as good.
void draw(const std::filesystem::path& output) {
    const std::string name = "sil/studies/identification/draw";
    try {
        if (!is_drawn(drawing_script(name), output)) {
            tell(fmt::format(
                "rsi-sil: no pictures were drawn; the calibration does not need them. Later: {} {}\n", name,
                output.string()));
        }
    } catch (const std::runtime_error& error) {
        tell(fmt::format("rsi-sil: no pictures were drawn; the calibration does not need them: {}\n",
                         error.what()));
    }
}

void identify_vehicle(IdentifyRequest& request) {
    prepare_identification_folder(request.output);
    refuse_unclear(request);
    const VehicleData vehicle = load_vehicle_data(request.vehicle_data, request.settings);
    IdentificationOptions options;
    options.preparation.until_s = request.until_s;
    options.keep_cg_height = request.keep_cg_height;
    if (!request.simulated_vehicle.empty()) {
        simulate_drives(request);
    }
    const Identification result =
        identify(vehicle, read_all(request.ramps), read_all(request.dynamics), options);
    fmt::print("{}", identification_report(result));
    write_identification(result, request.output);
    if (!request.no_pictures) {
        draw(request.output);
    }
    const std::string calibration = (request.output / "calibration.toml").string();
    fmt::print("\n{} is complete. Try it: rsi-sil replay DRIVE.csv --parameters {} --output FOLDER\n",
               calibration, calibration);
}

}  // namespace

// Results of an earlier identification must not be taken for those of this one, should it fail.
void prepare_identification_folder(const std::filesystem::path& output) {
    make_folder(output);
    for (const char* name :
         {"calibration.toml", "report.txt", "report.html", "fit.csv", "curve.csv", "fit.gp",
          "calibration.refused.toml", "roll_stiffness.svg", "roll_stiffness.png", "fit.svg", "fit.png"}) {
        remove_file(output / name);
    }
}

void write_identification(const Identification& result, const std::filesystem::path& output) {
    write_file_atomically(output / "report.txt", identification_report(result));
    write_file_atomically(output / "report.html", identification_page(result));
    write_file_atomically(output / "fit.csv", fit_csv(result));
    write_file_atomically(output / "curve.csv", curve_csv(result));
    write_file_atomically(output / "fit.gp", fit_marks(result));
    const std::filesystem::path calibration = output / "calibration.toml";
    write_file_atomically(calibration, calibration_text(result));
    try {
        load_calibration(calibration.string());
    } catch (const InputError& error) {
        const std::filesystem::path refused = output / "calibration.refused.toml";
        std::filesystem::rename(calibration, refused);
        throw std::runtime_error(
            fmt::format("the component would refuse what was fitted ({}). It is left in {} to look at; check "
                        "the vehicle data and "
                        "the drives' signs and units, and heed the warnings above",
                        error.what(), refused.string()));
    }
}

void add_identify_command(CLI::App& app) {
    const auto request = std::make_shared<IdentifyRequest>();
    CLI::App* identify =
        app.add_subcommand("identify", "Fit a vehicle's parameters to test drives and write its calibration");
    identify->add_option("--vehicle-data", request->vehicle_data,
                         "Data sheet of the vehicle (TOML; docs/calibration.md names the keys)");
    identify->add_option("--set", request->settings,
                         "KEY=VALUE in place of, or besides, the vehicle-data file");
    identify->add_option("--ramp", request->ramps,
                         "Drive CSV of a slow ramp steer or slowly increasing steer");
    identify->add_option("--dynamic", request->dynamics, "Drive CSV of a step steer, J-turn or lane change");
    identify->add_option("--output", request->output, "Folder for calibration.toml, report.txt and pictures")
        ->required();
    identify
        ->add_option("--until", request->until_s, "Use no sample later than this, in s on the drives' clocks")
        ->check(number_within(0.0, 1.0e9));
    identify->add_flag(
        "--keep-cg-height", request->keep_cg_height,
        "Keep the given CG height where the wheel loads speak for another; otherwise it is matched to them");
    identify->add_option("--simulate", request->simulated_vehicle,
                         "Drive this simulated vehicle (TOML) in place of --ramp and --dynamic");
    identify->add_flag("--noise", request->sensors.noise, "Simulated sensors with noise");
    add_whole_number(*identify, "--seed", request->sensors.seed, "Seed of the noise");
    identify->add_flag("--no-pictures", request->no_pictures, "Leave the pictures out");
    identify->callback([request] { identify_vehicle(*request); });
}

}  // namespace sil
