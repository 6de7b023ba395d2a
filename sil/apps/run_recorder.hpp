// Run recorder: what a run leaves in its folder, and its live account.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sil/apps/console_summary.hpp"
#include "sil/apps/firmware_csv.hpp"
#include "sil/page/page_recording.hpp"
#include "sil/results/signal_csv.hpp"
#include "sil/results/summary.hpp"
#include "sil/simulation/closed_loop.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Makes the folder. Results of an earlier run are removed: they must not be taken for those of this one,
// should it fail.
void prepare_run_folder(const std::filesystem::path& output);

class RunRecorder final : public RunObserver {
 public:
    // Begins signals.csv. `duration_s` as the account shows it.
    RunRecorder(std::filesystem::path output, double duration_s);

    // Files that need the firmware in this process: firmware.csv and lifts.csv. `outputs` must outlive the
    // recorder.
    void look_inside(const rsi::Outputs& outputs, const rsi::Parameters& calibration);

    ConsoleSummary& console() { return summary_; }

    void cycle(const Truth& truth, const SensorSample& sample, const EcuFrames& ecu,
               const RunEvents& events) override;
    void step(const Truth& truth) override;

    void close();

    const PageRecording& page() const { return page_; }

    // See Summary.
    std::vector<std::pair<std::string, std::optional<double>>> index_times_s() const;

 private:
    std::filesystem::path output_;
    SignalCsvWriter csv_;
    std::optional<FirmwareCsvWriter> firmware_{};
    std::optional<LiftCsvWriter> lifts_{};
    PageRecording page_{};
    ConsoleSummary summary_{};
    double duration_s_;
};

// summary.json, events.gp and report.html.
void write_run_results(const Summary& summary, const VehicleParameters& vehicle, const PageRecording& page,
                       const std::filesystem::path& output);

}  // namespace sil
