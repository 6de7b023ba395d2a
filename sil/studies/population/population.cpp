// Population: a row and the files of each vehicle, made by as many threads as wanted.
#include "sil/studies/population/population.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sil/files/csv_reader.hpp"
#include "sil/files/csv_writer.hpp"
#include "sil/files/file_io.hpp"
#include "sil/results/versions.hpp"
#include "sil/studies/campaign/row_file.hpp"
#include "sil/studies/population/calibrated_vehicle.hpp"
#include "sil/studies/population/population_campaigns.hpp"
#include "sil/studies/population/random_quantities.hpp"
#include "sil/studies/population/vehicle_draw.hpp"
#include "sil/studies/population/vehicle_writer.hpp"

namespace sil {
namespace {

struct FinishedVehicle {
    DrawnVehicle drawn{};
    double largest_ramp_ltr{0.0};
    Calibrated with_loads{};
    Calibrated without_loads{};
    Calibrated of_loaded_vehicle{};
};

// CSV cells hold no comma and no quotation mark, so that every reader splits a row at its commas.
std::string plain(std::string text) {
    for (char& letter : text) {
        letter = letter == ','                                ? ';'
                 : letter == '"'                              ? '\''
                 : static_cast<unsigned char>(letter) < 0x20U ? ' '
                                                              : letter;
    }
    return text;
}

std::string joined(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts) {
        all += (all.empty() ? "" : " | ") + text;
    }
    return plain(all);
}

class Cells {
 public:
    explicit Cells(bool names) : names_{names} {}
    void text(const std::string& name, const std::string& value) { row_.text(names_ ? name : value); }
    void count(const std::string& name, std::uint64_t value) { names_ ? row_.text(name) : row_.count(value); }
    void number(const std::string& name, double value) { names_ ? row_.text(name) : row_.number(value, 5); }
    const std::string& line() const { return row_.line(); }

 private:
    bool names_;
    CsvRow row_{};
};

void put_calibration(Cells& cells, const std::string& name, const Calibrated& calibrated) {
    cells.text(name, calibrated.failure.empty() ? "calibrated" : "failed: " + plain(calibrated.failure));
    cells.text(name + "_warnings", joined(calibrated.warnings));
}

std::string line_of(const FinishedVehicle& vehicle, bool names) {
    const DrawnVehicle& drawn = vehicle.drawn;
    const VehicleParameters& v = drawn.parameters;
    const VehicleProperties& p = drawn.properties;
    Cells cells{names};
    cells.count("number", drawn.number);
    cells.text("vehicle", drawn.name);
    cells.text("class", vehicle_classes()[drawn.in_class].name);
    cells.text("half", half_name(drawn.half));
    cells.count("refused_draws", drawn.attempt);
    cells.count("rigid_front", drawn.rigid_front ? 1U : 0U);
    cells.count("rigid_rear", drawn.rigid_rear ? 1U : 0U);
    cells.number("mass_kg", total_mass_kg(v));
    cells.number("wheelbase_m", wheelbase_m(v.geometry));
    cells.number("track_width_m", v.geometry.track_width_m);
    cells.number("cg_height_m", p.cg_height_m);
    cells.number("sprung_cg_height_m", v.geometry.cg_height_m);
    cells.number("static_stability_factor", p.static_stability_factor);
    cells.number("roll_centre_height_m", p.roll_centre_height_m);
    cells.number("roll_inertia_kgm2", v.inertia.sprung_roll_kgm2);
    cells.number("roll_stiffness_nmprad", p.roll_stiffness_nmprad);
    cells.number("roll_gradient_degpg", p.roll_gradient_degpg);
    cells.number("roll_frequency_hz", p.roll_frequency_hz);
    cells.number("roll_damping_ratio", p.roll_damping_ratio);
    cells.number("threshold_g", p.threshold_g);
    cells.number("grip", p.grip);
    cells.number("understeer_gradient_s2pm", p.understeer_gradient_s2pm);
    cells.number("steering_ratio", v.steering.ratio);
    cells.number("steering_lag_s", v.steering.lag_s);
    cells.number("relaxation_length_m", v.tyre.relaxation_length_m);
    const RearSuspensionParameters& rear = v.rear_suspension;
    cells.number("spring_progression_pm2", rear.spring_damper.progression_pm2);
    cells.number("dry_friction", rear.spring_damper.dry_friction);
    cells.number("frame_over_roll_stiffness", rear.frame_torsion_nmprad / p.roll_stiffness_nmprad);
    cells.number("largest_ramp_ltr", vehicle.largest_ramp_ltr);
    put_calibration(cells, "with_wheel_loads", vehicle.with_loads);
    put_calibration(cells, "without_wheel_loads", vehicle.without_loads);
    put_calibration(cells, "loaded", vehicle.of_loaded_vehicle);
    return cells.line();
}

DrawnVehicle drawn_vehicle(const PopulationRequest& request, std::uint64_t number) {
    DrawnVehicle drawn = draw_vehicle(request.seed, number);
    drawn.half = request.only_report ? PopulationHalf::report : drawn.half;
    return drawn;
}

FinishedVehicle make_vehicle(const PopulationRequest& request, std::uint64_t number) {
    FinishedVehicle made;
    made.drawn = drawn_vehicle(request, number);
    const DrawnVehicle& drawn = made.drawn;
    const std::filesystem::path& folder = request.output;
    const VehicleParameters with_load = loaded(drawn.parameters, vehicle_classes()[drawn.in_class].load);
    const auto write = [&](const VehicleParameters& vehicle, bool is_loaded) {
        write_file_atomically(
            vehicle_file(folder, drawn, is_loaded),
            vehicle_toml(vehicle, fmt::format("{}, vehicle {} of the population with seed {}{}. SI units.",
                                              vehicle_classes()[drawn.in_class].name, number, request.seed,
                                              is_loaded ? ", loaded" : "")));
        write_file_atomically(data_file(folder, drawn, is_loaded), vehicle_data_toml(vehicle));
    };
    write(drawn.parameters, false);
    write(with_load, true);
    const auto calibrated = [&](const IdentificationDrives& drives, CalibrationKind kind) {
        return calibrate(data_file(folder, drawn, kind == CalibrationKind::of_loaded_vehicle), drives,
                         calibration_file(folder, drawn, kind));
    };
    // Test drivers stop where they no longer dare to go on: some early, some just before a wheel lifts.
    const double back_from_ltr =
        RandomQuantities{request.seed, number, 0U}.within(Quantity::ramp_end, {0.6, 0.9});
    // Two seeds a pair of drives, two pairs a vehicle.
    const std::uint64_t sensor_seed = 4U * number + 1U;
    try {
        const IdentificationDrives drives =
            identification_drives(drawn.parameters, back_from_ltr, sensor_seed);
        made.largest_ramp_ltr = drives.largest_ramp_ltr;
        made.with_loads = calibrated(drives, CalibrationKind::with_loads);
        made.without_loads = calibrated(drives.without_loads(), CalibrationKind::without_loads);
    } catch (const std::runtime_error& error) {
        made.with_loads.failure = made.without_loads.failure = error.what();
    }
    try {
        made.of_loaded_vehicle = calibrated(identification_drives(with_load, back_from_ltr, sensor_seed + 2U),
                                            CalibrationKind::of_loaded_vehicle);
    } catch (const std::runtime_error& error) {
        made.of_loaded_vehicle.failure = error.what();
    }
    return made;
}

// Origin of the files in the folder, so that those of different seeds or programs do not get mixed.
void prepare_folder(const PopulationRequest& request) {
    make_folder(request.output);
    for (const char* name : {"vehicles", "vehicles_loaded", "data", "data_loaded", "calibrations",
                             "calibrations_without_loads", "calibrations_loaded"}) {
        make_folder(request.output / name);
    }
    const Versions versions = built_versions();
    const std::string wanted = fmt::format(
        "# The population whose vehicles are beside; `rsi-sil population` wrote it.\n"
        "seed = {}\n{}component = \"{}\"\ngit_revision = \"{}\"\n",
        request.seed, request.only_report ? "only_report = true\n" : "", versions.component,
        versions.git_revision);
    const std::filesystem::path file = request.output / "population.toml";
    if (!std::filesystem::exists(file)) {
        write_file_atomically(file, wanted);
    } else if (read_whole_file(file) != wanted) {
        throw InputError(fmt::format(
            "{} is of another seed or another revision of this program; use another output folder",
            file.string()));
    }
}

void write_settings(const PopulationRequest& request) {
    std::map<PopulationHalf, std::vector<DrawnVehicle>> halves{{PopulationHalf::choose, {}},
                                                               {PopulationHalf::report, {}}};
    for (std::uint64_t number = 0U; number < request.vehicles; ++number) {
        DrawnVehicle vehicle = drawn_vehicle(request, number);
        halves[vehicle.half].push_back(std::move(vehicle));
    }
    for (const auto& [half, vehicles] : halves) {
        for (const CampaignVariant variant : campaign_variants()) {
            const CampaignSettings settings =
                population_campaign(request.output, vehicles, variant, request.seed);
            const std::filesystem::path file =
                request.output / fmt::format("settings_{}_{}.toml", half_name(half), variant_name(variant));
            if (settings.vehicles.empty()) {
                std::filesystem::remove(file);
                continue;
            }
            write_file_atomically(
                file,
                fmt::format(
                    "# {} of {} vehicles of this half are calibrated. `rsi-sil population` wrote it.\n{}",
                    settings.vehicles.size(), vehicles.size(), to_toml(settings)));
        }
    }
}

}  // namespace

RowProgress make_population(const PopulationRequest& request, const std::atomic<bool>& stop,
                            const RowListener& listener) {
    constexpr std::uint64_t most_vehicles = 1'000'000U;
    if (request.vehicles < 1U || request.vehicles > most_vehicles) {
        throw InputError(
            fmt::format("--vehicles wants a number from 1 to {}, not {}", most_vehicles, request.vehicles));
    }
    prepare_folder(request);
    RowFile file{request.output / "vehicles.csv", line_of({}, true)};
    if (!file.finished_runs().empty() && *file.finished_runs().rbegin() >= request.vehicles) {
        throw InputError(fmt::format("{} has vehicle {} already; their number can grow, not shrink to {}",
                                     request.output.string(), *file.finished_runs().rbegin(),
                                     request.vehicles));
    }
    const auto make = [&request](std::uint64_t number) {
        return MadeRow{line_of(make_vehicle(request, number), false)};
    };
    const RowProgress progress = make_rows(file, {request.vehicles, request.jobs, make}, stop, listener);
    if (progress.finished >= progress.total) {
        write_settings(request);
    }
    return progress;
}

std::string describe_population(const std::filesystem::path& population) {
    const std::string text = read_whole_file(population / "vehicles.csv");
    CsvLines lines{text};
    CsvLine line;
    std::vector<CsvField> cells;
    lines.next(line);
    split_fields(line.text, cells);
    const auto column = [&cells](const char* name) {
        return static_cast<std::size_t>(
            std::find_if(cells.begin(), cells.end(),
                         [name](const CsvField& cell) { return cell.text == name; }) -
            cells.begin());
    };
    const std::size_t class_column = column("class");
    const std::size_t vehicle_column = column("vehicle");
    const std::array<const char*, 3> kinds{"with_wheel_loads", "without_wheel_loads", "loaded"};
    std::array<std::size_t, kinds.size()> kind_columns{};
    std::transform(kinds.begin(), kinds.end(), kind_columns.begin(), column);
    std::map<std::string, std::array<std::uint64_t, 4>> classes;
    std::string failures;
    while (lines.next(line) && line.is_ended) {
        split_fields(line.text, cells);
        auto& counts = classes[std::string{cells.at(class_column).text}];
        ++counts[0];
        for (std::size_t kind = 0U; kind < kinds.size(); ++kind) {
            const std::string_view result = cells.at(kind_columns[kind]).text;
            if (result == "calibrated") {
                ++counts[kind + 1U];
            } else {
                failures += fmt::format("{}, {}: {}\n", cells.at(vehicle_column).text, kinds[kind], result);
            }
        }
    }
    std::string report = "class          vehicles  calibrated  without wheel loads  loaded\n";
    for (const auto& [name, counts] : classes) {
        report += fmt::format("{:<14} {:>8}  {:>10}  {:>19}  {:>6}\n", name, counts[0], counts[1], counts[2],
                              counts[3]);
    }
    return report + failures +
           fmt::format("All of it is in {}. Try: rsi-sil campaign run --settings {} --output FOLDER\n",
                       (population / "vehicles.csv").string(),
                       (population / "settings_report_errors.toml").string());
}

}  // namespace sil
