// False codes: drives whose sensors are good, noise and offsets of good sensors included, must not set any
// diagnostic code. Every manoeuvre with every vehicle, then drawn runs of the built-in campaign and the van,
// with a roll angle against the road and against the horizon.
//   false_codes FIRST COUNT [SETTINGS [every-kind]]    the drawn runs, or those of these settings alone, as
//   of
//                                                      a population; with every kind of good sensors in turn.
//                                                      Exit status 1 when a code was set
#include <fmt/core.h>

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sil/files/calibration_file.hpp"
#include "sil/simulation/in_process_run.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/studies/campaign/campaign_run.hpp"
#include "sil/studies/campaign/settings.hpp"
#include "sil/studies/faults/good_sensors.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace {

using rsi::can_dbc::RolloverDiagnosis;

struct Finding {
    int runs{0};
    std::string where{};
};

class CodeListener final : public sil::RunObserver {
 public:
    void cycle(const sil::Truth& truth, const sil::SensorSample&, const sil::EcuFrames& ecu,
               const sil::RunEvents&) override {
        const RolloverDiagnosis& diagnosis = ecu.diagnosis();
        if (diagnosis.code_status == RolloverDiagnosis::CodeStatus::confirmed) {
            codes.emplace(static_cast<int>(diagnosis.code), truth.time_s);
        }
    }

    std::map<int, double> codes{};  // with the time at which each was first reported
};

class Search {
 public:
    void drive(const std::string& name, sil::InProcessRun& run) {
        CodeListener listener;
        run.run(listener);
        ++runs_;
        for (const auto& [code, time_s] : listener.codes) {
            Finding& finding = findings_[code];
            ++finding.runs;
            if (finding.runs <= 5) {
                finding.where += fmt::format("\n    {} at {:.2f} s", name, time_s);
            }
        }
    }

    int report() const {
        for (const auto& [code, finding] : findings_) {
            fmt::print("code {} in {} runs:{}\n", code, finding.runs, finding.where);
        }
        fmt::print("{} runs, {} codes\n", runs_, findings_.size());
        return findings_.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
    }

 private:
    int runs_{0};
    std::map<int, Finding> findings_{};
};

const char* suffix(const sil::CampaignSettings& settings) {
    return settings.spread.attitude_sensor ? ", attitude sensor" : "";
}

void drive_catalogue(Search& search, const sil::CampaignSettings& settings) {
    for (const sil::CampaignVehicle& built : settings.vehicles) {
        const sil::VehicleParameters vehicle = sil::load_vehicle(built.parameters);
        const rsi::Parameters calibration = sil::load_calibration(built.calibration, settings.changes);
        for (const sil::Manoeuvre& manoeuvre : sil::undisturbed_manoeuvres()) {
            for (const bool noise : {false, true}) {
                sil::SensorFlaws flaws;
                flaws.noise = noise;
                flaws.bank_sensor = noise;
                flaws.attitude_sensor = settings.spread.attitude_sensor;
                sil::RunOptions options;
                options.mirrored = noise;
                sil::InProcessRun run{vehicle, manoeuvre, options, sil::mounted_sensors(vehicle, flaws),
                                      calibration};
                search.drive(
                    fmt::format("{} {} {}{}", std::filesystem::path{built.parameters}.stem().string(),
                                manoeuvre.name, noise ? "with noise" : "ideal", suffix(settings)),
                    run);
            }
        }
    }
}

void drive_campaign(Search& search, const sil::CampaignSettings& settings, std::uint64_t first,
                    std::uint64_t count, bool every_kind) {
    const sil::CampaignWorld world{settings};
    for (std::uint64_t number = first; number < first + count; ++number) {
        const sil::DrawnRun drawn = world.prepare(number);
        sil::GoodSensors sensors{"", drawn.sensors, drawn.calibration};
        if (every_kind) {
            const std::vector<sil::GoodSensors> kinds = sil::good_sensors(drawn.sensors, drawn.calibration);
            sensors = kinds[number % kinds.size()];
        }
        sil::InProcessRun run{drawn.vehicle, drawn.manoeuvre, drawn.options, sensors.options,
                              sensors.calibration};
        search.drive(fmt::format("run {} {} {}{}, {}", number, drawn.draw.vehicle, drawn.manoeuvre.name,
                                 suffix(settings), sensors.name),
                     run);
    }
}

sil::CampaignSettings built_in_and_van(std::uint64_t runs) {
    sil::CampaignSettings settings = sil::default_campaign();
    settings.runs = runs;
    settings.vehicles.push_back({"sil/vehicles/van.toml", "firmware/calibrations/van.toml"});
    for (sil::CampaignVehicle& vehicle : settings.vehicles) {
        vehicle.parameters.insert(0U, RSI_SOURCE_DIR "/");
        vehicle.calibration.insert(0U, RSI_SOURCE_DIR "/");
    }
    return settings;
}

}  // namespace

int main(int argc, char** argv) try {
    const bool every_kind = argc == 5 && std::string_view{argv[4]} == "every-kind";
    if (argc < 3 || argc > 5 || (argc == 5 && !every_kind)) {
        fmt::print(stderr,
                   "Use: false_codes FIRST COUNT [SETTINGS [every-kind]], the numbers of the drawn runs\n");
        return 2;
    }
    const std::uint64_t first = std::strtoull(argv[1], nullptr, 10);
    const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
    Search search;
    if (argc > 3) {
        sil::CampaignSettings settings = sil::load_campaign(argv[3]);
        settings.runs = first + count;
        drive_campaign(search, settings, first, count, every_kind);
        return search.report();
    }
    const sil::CampaignSettings against_road = built_in_and_van(first + count);
    sil::CampaignSettings against_horizon = against_road;
    against_horizon.spread.attitude_sensor = true;
    against_horizon.changes.emplace_back("roll_angle_reference=horizon");
    for (const sil::CampaignSettings& settings : {against_road, against_horizon}) {
        drive_catalogue(search, settings);
        drive_campaign(search, settings, first, count, false);
    }
    return search.report();
} catch (const std::exception& error) {
    fmt::print(stderr, "false_codes: {}\n", error.what());
    return EXIT_FAILURE;
}
