#include "sil/studies/procedures/step_drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "sil/files/file_io.hpp"
#include "sil/results/event_marks.hpp"
#include "sil/results/signal_csv.hpp"
#include "sil/simulation/in_process_run.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/units.hpp"
#include "sil/world/vehicle/mirror.hpp"

namespace sil {
namespace {

struct StateChange {
    double time_s;
    WarningState state;
    WarningSide side;
};

class StepObserver final : public RunObserver {
 public:
    StepObserver(StepMeasurement& measurement, bool mirrored, const std::filesystem::path& signals)
        : measurement_{measurement}, mirrored_{mirrored} {
        if (!signals.empty()) {
            make_folder(signals);
            csv_.emplace(signals / "signals.csv");
        }
    }

    void cycle(const Truth& truth, const SensorSample& sample, const EcuFrames& ecu,
               const RunEvents& /*events*/) override {
        const EcuOutput& output = ecu.output();
        if (changes_.empty() || changes_.back().state != output.state() ||
            changes_.back().side != output.side()) {
            changes_.push_back({truth.time_s, output.state(), output.side()});
        }
        if (csv_) {
            csv_->write(signal_csv_row(truth, sample, output));
        }
    }

    void step(const Truth& truth) override {
        drive_.largest_roll_rad = std::max(drive_.largest_roll_rad, std::abs(truth.roll_angle_rad));
        drive_.two_wheel_height_m = std::max(drive_.two_wheel_height_m, two_wheel_height_m(truth));
        measurement_.step(mirrored_ ? mirrored(truth) : truth);
    }

    bool settled() const override { return measurement_.finished(); }

    StepDrive drive(const RunEvents& events, double duration_s) {
        if (csv_) {
            csv_->close();
        }
        drive_.completed = measurement_.finished() || events.end_time_s >= duration_s - cycle_time_s;
        drive_.warning = warning(events);
        return drive_;
    }

 private:
    WarningBeside warning(const RunEvents& events) const {
        const WarningJudgement& judgement = events.judgement;
        WarningBeside beside;
        beside.largest_load_transfer_ratio = judgement.largest_load_transfer_ratio;
        beside.first_advisory_s = first(WarningState::advisory).first;
        std::tie(beside.first_warning_s, beside.first_warning_side) = first(WarningState::warning);
        if (events.two_wheel_lift) {
            beside.lifted = true;
            beside.lift_off_s = events.two_wheel_lift->time_s;
            beside.falling_side = judgement.falling_side;
            beside.side_at_lift_off = judgement.side_at_lift_off;
            beside.lead_s = judgement.lead_s;
            for (const StateChange& change : changes_) {
                if (change.time_s <= beside.lift_off_s + time_rounding_s) {
                    beside.state_at_lift_off = change.state;
                }
            }
        }
        return beside;
    }

    std::pair<std::optional<double>, WarningSide> first(WarningState state) const {
        const auto found = std::find_if(changes_.begin(), changes_.end(),
                                        [state](const StateChange& change) { return change.state == state; });
        if (found == changes_.end()) {
            return {std::nullopt, WarningSide::none};
        }
        return {found->time_s, found->side};
    }

    StepMeasurement& measurement_;
    bool mirrored_;
    std::optional<SignalCsvWriter> csv_{};
    std::vector<StateChange> changes_{};
    StepDrive drive_{};
};

}  // namespace

double two_wheel_height_m(const Truth& truth) {
    const auto& gap = truth.wheel_gap_m;
    return std::max(std::min(gap[front_left], gap[rear_left]), std::min(gap[front_right], gap[rear_right]));
}

StepDrive drive_step(const ProcedureWorld& world, const std::string& name, const Manoeuvre& manoeuvre,
                     bool mirrored, StepMeasurement& measurement) {
    RunOptions options;
    options.mirrored = mirrored;
    InProcessRun run{world.vehicle, manoeuvre, options, mounted_sensors(world.vehicle, SensorFlaws{}),
                     world.calibration};
    const std::filesystem::path signals =
        world.signals.empty() ? std::filesystem::path{} : world.signals / name;
    StepObserver observer{measurement, mirrored, signals};
    const RunEvents& events = run.run(observer);
    if (!signals.empty()) {
        write_event_marks(events, static_stability_factor(world.vehicle),
                          fmt::format("{}, {}", name, world.vehicle.name), signals / "events.gp");
    }
    return observer.drive(events, run.duration_s());
}

std::vector<Figure> motion_figures(const StepDrive& drive) {
    return {{"largest_roll_deg", "largest roll", "deg", 1, drive.largest_roll_rad * degrees_per_radian},
            {"two_wheel_height_mm", "two wheels up", "mm", 0, drive.two_wheel_height_m * 1000.0},
            {"largest_ltr", "largest |LTR|", "", 2, drive.warning.largest_load_transfer_ratio}};
}

}  // namespace sil
