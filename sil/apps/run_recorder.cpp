#include "sil/apps/run_recorder.hpp"

#include <fmt/format.h>

#include "sil/files/file_io.hpp"
#include "sil/page/page_text.hpp"
#include "sil/page/summary_facts.hpp"
#include "sil/results/event_marks.hpp"

namespace sil {

void prepare_run_folder(const std::filesystem::path& output) {
    make_folder(output);
    // The last two are of `sil/tools/logs decode`.
    for (const char* name : {"signals.csv", "events.gp", "summary.json", "firmware.csv", "lifts.csv",
                             "report.html", "signals.mf4", "run.mcap"}) {
        remove_file(output / name);
    }
}

RunRecorder::RunRecorder(std::filesystem::path output, double duration_s)
    : output_{std::move(output)}, csv_{output_ / "signals.csv"}, duration_s_{duration_s} {}

void RunRecorder::look_inside(const rsi::Outputs& outputs, const rsi::Parameters& calibration) {
    firmware_.emplace(output_ / "firmware.csv", outputs, calibration);
    lifts_.emplace(output_ / "lifts.csv");
}

void RunRecorder::cycle(const Truth& truth, const SensorSample& sample, const EcuFrames& ecu,
                        const RunEvents& events) {
    const std::string row = signal_csv_row(truth, sample, ecu.output());
    csv_.write(row);
    page_.cycle(row, ecu, truth.time_s);
    if (firmware_) {
        firmware_->write(truth);
    }
    summary_.cycle(truth, ecu, events, duration_s_);
}

void RunRecorder::step(const Truth& truth) {
    if (lifts_) {
        lifts_->observe(truth);
    }
}

void RunRecorder::close() {
    csv_.close();
    if (firmware_) {
        firmware_->close();
        lifts_->close();
    }
}

std::vector<std::pair<std::string, std::optional<double>>> RunRecorder::index_times_s() const {
    return firmware_ ? firmware_->index_times_s()
                     : std::vector<std::pair<std::string, std::optional<double>>>{};
}

void write_run_results(const Summary& summary, const VehicleParameters& vehicle, const PageRecording& page,
                       const std::filesystem::path& output) {
    write_event_marks(summary.events, static_stability_factor(vehicle),
                      fmt::format("{}, {}", summary.manoeuvre, summary.vehicle), output / "events.gp");
    const PageHead head{
        fmt::format("{}{}", summary.manoeuvre, summary.mirrored ? ", mirrored" : ""),
        fmt::format("{}, {}", summary.vehicle, pace_name(summary.in_process, summary.lock_step)),
        page_vehicle(vehicle), summary_facts(summary)};
    write_file_atomically(output / "report.html", page_with(page.json(head, summary.events)));
    write_summary(summary, output / "summary.json");
}

}  // namespace sil
