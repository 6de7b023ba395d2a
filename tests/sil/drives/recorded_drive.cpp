#include "tests/sil/drives/recorded_drive.hpp"

#include <cstdio>

#include "sil/files/calibration_file.hpp"
#include "sil/files/candump_log.hpp"
#include "sil/results/signal_csv.hpp"
#include "sil/simulation/closed_loop.hpp"
#include "sil/simulation/in_process_pace.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/simulation/recorded_bus.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace testing_drives {
namespace {

const std::string project_folder = RSI_PROJECT_FOLDER;

class CycleRecorder final : public sil::RunObserver {
 public:
    CycleRecorder(RecordedDrive& drive, const std::filesystem::path& path) : drive_{drive}, csv_{path} {}
    void cycle(const sil::Truth& truth, const sil::SensorSample& sample, const sil::EcuFrames& ecu,
               const sil::RunEvents&) override {
        drive_.ecu_outputs.push_back(ecu.output());
        csv_.write(sil::signal_csv_row(truth, sample, ecu.output()));
    }
    void close() { csv_.close(); }

 private:
    RecordedDrive& drive_;
    sil::SignalCsvWriter csv_;
};

}  // namespace

rsi::Parameters large_suv_calibration() {
    return sil::load_calibration(project_folder + "/firmware/calibrations/large_suv.toml");
}

sil::Manoeuvre hard_turn() {
    return sil::find_manoeuvre("j-turn-110");
}

RecordedDrive record_drive(const sil::Manoeuvre& manoeuvre, double duration_s,
                           const std::filesystem::path& folder, bool noise) {
    sil::RunOptions options;
    options.duration_s = duration_s;
    sil::ManoeuvreRun plant{sil::load_vehicle(project_folder + "/sil/vehicles/large_suv.toml"), manoeuvre,
                            options};
    sil::SensorSuite sensors{sil::mounted_sensors(plant.vehicle().parameters(), {noise, 7U})};
    sil::InProcessEcu ecu{large_suv_calibration()};
    sil::CandumpLogWriter log{folder / "candump.log"};
    sil::RecordedBus bus{ecu.world_bus(), ecu.clock(), log, "vcan0"};
    sil::InProcessPace pace{ecu};
    sil::ClosedLoop loop{plant, sensors, bus, pace};

    RecordedDrive drive;
    CycleRecorder recorder{drive, folder / "signals.csv"};
    loop.run(recorder);
    recorder.close();
    log.close();
    drive.events = loop.events();
    return drive;
}

std::vector<std::string> changes(const std::vector<sil::EcuOutput>& outputs) {
    std::vector<std::string> result;
    std::string previous;
    for (std::size_t index = 0U; index < outputs.size(); ++index) {
        const std::string words =
            std::string{sil::to_string(outputs[index].state())} + " " + sil::to_string(outputs[index].side());
        if (words != previous) {
            result.push_back(std::to_string(index) + " " + words);
        }
        previous = words;
    }
    return result;
}

}  // namespace testing_drives
