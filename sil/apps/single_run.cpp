#include "sil/apps/single_run.hpp"

#include <fmt/format.h>

#include "sil/apps/run_recorder.hpp"
#include "sil/files/file_io.hpp"
#include "sil/files/parameter_section_file.hpp"
#include "sil/page/summary_facts.hpp"
#include "sil/results/versions.hpp"

namespace sil {
namespace {

std::string drawn_text(const DrawnRun& drawn) {
    const RunDraw& draw = drawn.draw;
    return fmt::format(
        "Run {}: {}{}, {}\n"
        "  drawn: speed {:.3f}, steering {:.3f}, friction {:.3f} times its own; "
        "load {:.1f} % of the sprung mass at {:.2f} times its CG height\n"
        "  the firmware is wrong by: CG height {:+.1f} %, roll stiffness {:+.1f} %, sprung mass {:+.1f} %, "
        "mass on the bus {:+.1f} %; bias {:+.3f} g lateral, {:+.3f} g vertical; sensor seed {}\n",
        draw.number, drawn.manoeuvre.name, draw.mirrored ? ", mirrored" : "", drawn.vehicle.name,
        draw.speed_factor, draw.steering_factor, draw.friction_factor, 100.0 * draw.load_share,
        draw.load_height_factor, 100.0 * draw.cg_height_error, 100.0 * draw.stiffness_error,
        100.0 * draw.mass_error, 100.0 * draw.mass_sensor_error, draw.lateral_bias_g, draw.vertical_bias_g,
        draw.sensor_seed);
}

class SingleRun final : public RunWatch {
 public:
    explicit SingleRun(std::filesystem::path output) : output_{std::move(output)} {}

    void begin(const InProcessRun& run, const DrawnRun& drawn) override {
        run_ = &run;
        vehicle_ = run.vehicle();
        summary_.manoeuvre = drawn.manoeuvre.name;
        summary_.vehicle = drawn.vehicle.name;
        summary_.mirrored = drawn.options.mirrored;
        summary_.in_process = true;
        summary_.seed = drawn.draw.sensor_seed;
        summary_.bias_g = drawn.draw.lateral_bias_g;
        summary_.versions = built_versions();
        prepare_run_folder(output_);
        write_file_atomically(output_ / "calibration.toml", calibration_toml(drawn.calibration));
        fmt::print("{}", drawn_text(drawn));
        recorder_.emplace(output_, run.duration_s());
        recorder_->look_inside(run.outputs(), drawn.calibration);
        recorder_->console().begin(drawn.manoeuvre, drawn.options, pace_name(true, false), run.duration_s());
    }

    void cycle(const Truth& truth, const SensorSample& sample, const EcuFrames& ecu,
               const RunEvents& events) override {
        recorder_->cycle(truth, sample, ecu, events);
        // The run is gone when its row is there.
        summary_.events = events;
        summary_.frames_sent = run_->frames_sent();
        frames_ = ecu;
    }
    void step(const Truth& truth) override { recorder_->step(truth); }

    void close(bool noise) {
        summary_.noise = noise ? "noise" : "none";
        summary_.frames_received = frames_.frames_received();
        summary_.index_times_s = recorder_->index_times_s();
        recorder_->console().end(summary_.events, frames_, summary_.frames_sent, 0U);
        recorder_->close();
        write_run_results(summary_, vehicle_, recorder_->page(), output_);
    }

 private:
    std::filesystem::path output_;
    const InProcessRun* run_{nullptr};
    VehicleParameters vehicle_{};
    EcuFrames frames_{};
    Summary summary_{};
    std::optional<RunRecorder> recorder_{};
};

}  // namespace

CampaignRow drive_single_run(const CampaignWorld& world, std::uint64_t number,
                             const std::filesystem::path& output) {
    SingleRun run{output};
    CampaignRow row = world.run(number, &run);
    run.close(world.settings().spread.sensor_noise);
    return row;
}

}  // namespace sil
