#include "sil/studies/drives/drive_replay.hpp"

#include <algorithm>
#include <cmath>

#include "hal/memory/frame_replay.hpp"
#include "rsi/hal/can_bus.hpp"
#include "sil/simulation/ecu_frames.hpp"
#include "sil/simulation/in_process_ecu.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/simulation/replay.hpp"
#include "sil/simulation/sensor_frames.hpp"
#include "sil/studies/drives/drive.hpp"
#include "sil/studies/drives/felt_load_transfer.hpp"
#include "sil/studies/drives/resample.hpp"

namespace sil {
namespace {

// Input of EventObserver; the wheels stay on the road, because lift-off is found elsewhere, and the
// warning is judged by it.
Truth known_truth(const ReplayCycle& cycle) {
    Truth truth;
    truth.time_s = cycle.sample.time_s;
    truth.lateral_acceleration_mps2 = static_cast<double>(cycle.outputs.lateral_acceleration_mps2);
    truth.roll_angle_rad = cycle.sample.roll_angle_rad;
    truth.wheel_load_n.fill(1.0);
    return truth;
}

// Steps the firmware and keeps what it says.
class Recorder {
 public:
    Recorder(const rsi::Parameters& parameters, const Interruption& interrupted)
        : interrupted_{interrupted},
          ecu_{parameters},
          events_{static_stability_factor(parameters)},
          height_share_{height_share(parameters)} {}

    InProcessEcu& ecu() { return ecu_; }

    // After the cycle's frames have been sent.
    void step(const DriveSample& sample, bool has_frames) {
        if (interrupted_ && interrupted_()) {
            throw ReplayInterrupted{};
        }
        ecu_.step();
        bool has_answer = false;
        rsi::hal::CanFrame frame;
        while (ecu_.world_bus().receive(frame) == rsi::hal::ReceiveResult::frame) {
            const EcuFrameKind kind = frames_.take(frame);
            has_answer = has_answer || kind == EcuFrameKind::warning;
            if (kind == EcuFrameKind::diagnosis) {
                codes_.take(frames_.diagnosis());
            }
        }
        ReplayCycle cycle;
        cycle.sample = sample;
        cycle.outputs = ecu_.ecu().outputs();
        cycle.ecu = frames_.output();
        cycle.load_transfer_ratio = load_transfer_ratio(sample);
        cycle.warning_level = static_cast<double>(cycle.outputs.warning_level);
        cycle.codes = codes_.codes();
        result_.confirmed_codes |= cycle.codes.confirmed;
        events_.observe(known_truth(cycle));
        judge_.observe(sample.time_s, cycle.load_transfer_ratio);
        if (has_answer) {
            events_.observe(cycle.ecu, sample.time_s);
            judge_.observe(cycle.ecu.state(), cycle.ecu.side(), sample.time_s);
            warnings_.observe(cycle.ecu.state(), cycle.ecu.side(), sample.time_s);
        }
        result_.silent_cycles += has_frames ? 0U : 1U;
        result_.cycles.push_back(cycle);
    }

    DriveReplay finish(const LiftOff& lift_off, std::uint64_t frames_sent) {
        result_.events = events_.events();
        result_.lift_off = lift_off;
        result_.events.one_wheel_lift = moment(lift_off.one_wheel_s);
        result_.events.two_wheel_lift = moment(lift_off.two_wheel_s);
        if (result_.events.two_wheel_lift) {
            judge_.lift_off({*result_.events.two_wheel_lift, falling_side(lift_off)});
        }
        result_.events.judgement = judge_.judgement();
        result_.frames_sent = frames_sent;
        result_.frames_received = frames_.frames_received();
        find_largest();
        for (const NamedWarning& warning : warnings_.all()) {
            result_.warnings.push_back({warning, felt_load_transfer(result_.cycles, height_share_, warning)});
        }
        return std::move(result_);
    }

 private:
    // At `time_s`, with the values of the latest cycle until then.
    std::optional<EventMoment> moment(const std::optional<double>& time_s) const {
        if (!time_s) {
            return std::nullopt;
        }
        EventMoment result{*time_s, EcuOutput::not_available, EcuOutput::not_available};
        for (const ReplayCycle& cycle : result_.cycles) {
            if (cycle.sample.time_s > *time_s + 0.5 * cycle_time_s) {
                break;
            }
            result.lateral_acceleration_mps2 = static_cast<double>(cycle.outputs.lateral_acceleration_mps2);
            result.roll_angle_rad = cycle.sample.roll_angle_rad;
        }
        return result;
    }

    // Without wheel loads the vehicle falls to the outside of its turn.
    WarningSide falling_side(const LiftOff& lift_off) const {
        return lift_off.falling_side != WarningSide::none
                   ? lift_off.falling_side
                   : loaded_side(result_.events.two_wheel_lift->lateral_acceleration_mps2);
    }

    void find_largest() {
        const std::optional<double>& end_s = result_.lift_off.two_wheel_s;
        for (const ReplayCycle& cycle : result_.cycles) {
            if (end_s && cycle.sample.time_s >= *end_s) {
                break;
            }
            // std::fmax takes the number beside a NaN.
            result_.largest_load_transfer_ratio =
                std::fmax(result_.largest_load_transfer_ratio, std::fabs(cycle.load_transfer_ratio));
            result_.largest_warning_level = std::fmax(result_.largest_warning_level, cycle.warning_level);
        }
    }

    const Interruption& interrupted_;
    InProcessEcu ecu_;
    EcuFrames frames_;
    EventObserver events_;
    WarningJudge judge_;
    NamedWarnings warnings_;
    CodeListener codes_;
    double height_share_;
    DriveReplay result_;
};

double seconds(rsi::hal::Time time) {
    return static_cast<double>(time.nanoseconds) * 1.0e-9;
}

}  // namespace

DriveReplay replay_drive(const Drive& drive, const rsi::Parameters& parameters,
                         const Interruption& interrupted) {
    Recorder recorder{parameters, interrupted};
    SensorFrames sensors;
    rsi::hal::Time time{};
    for (const DriveCycle& cycle : to_cycles(drive)) {
        recorder.ecu().clock().set(time);
        if (cycle.has_frames) {
            sensors.send(recorder.ecu().world_bus(), cycle.sample);
        }
        recorder.step(cycle.sample, cycle.has_frames);
        time = time + cycle_time;
    }
    return recorder.finish(find_lift_off(drive), sensors.frames_sent());
}

DriveReplay replay_drive(const std::vector<LoggedFrame>& log, const rsi::Parameters& parameters,
                         const Interruption& interrupted) {
    const std::vector<rsi::hal::CanFrame> frames = replayable_frames(log);
    Recorder recorder{parameters, interrupted};
    rsi::hal::FrameReplay player{frames.data(), frames.size(), recorder.ecu().clock(),
                                 recorder.ecu().world_bus()};
    const rsi::hal::Time start = frames.front().receive_time;
    std::size_t taken = 0U;
    for (rsi::hal::Time time = start; !player.finished(); time = time + cycle_time) {
        player.run_until(time);
        DriveSample sample;
        sample.time_s = seconds(time - start);
        const std::size_t first = taken;
        for (; taken < frames.size() && !(time < frames[taken].receive_time); ++taken) {
            take_sensor_frame(frames[taken], sample);
        }
        recorder.step(sample, taken > first);
    }
    return recorder.finish({}, frames.size());
}

double static_stability_factor(const rsi::Parameters& parameters) {
    return static_cast<double>(parameters.track_width_m) /
           (2.0 * static_cast<double>(parameters.sprung_cg_height_m));
}

}  // namespace sil
