#include "sil/simulation/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "hal/memory/frame_replay.hpp"
#include "rsi/ecu/application/sensor_reception.hpp"
#include "sil/files/sensor_frame.hpp"
#include "sil/simulation/in_process_ecu.hpp"
#include "sil/simulation/pace.hpp"

namespace sil {
namespace {

// Recorders of several buses write that much out of order; as sil/tools/recorded.py has it.
constexpr rsi::hal::Time longest_disorder = rsi::hal::Time::from_milliseconds(200);
// A longer gap means two recordings on different clocks; stepping through it could take arbitrarily long.
constexpr rsi::hal::Time longest_gap = rsi::hal::Time::from_milliseconds(3'600'000);
// More do not fit into the memory of every machine.
constexpr rsi::hal::Time longest_log = rsi::hal::Time::from_milliseconds(12 * 3'600'000);

double seconds(rsi::hal::Time time) {
    return static_cast<double>(time.nanoseconds) * 1.0e-9;
}

[[noreturn]] void refuse_without_sensor_frames() {
    std::string expected;
    for (const std::uint32_t identifier : rsi::application::received_identifiers) {
        expected += fmt::format("{}0x{:03X}", expected.empty() ? "" : ", ", identifier);
    }
    throw ReplayError{0U, fmt::format("there is no sensor frame in this log; the firmware receives the "
                                      "standard identifiers {}",
                                      expected)};
}

// Those of one time keep their order.
void sort_by_time(std::vector<rsi::hal::CanFrame>& frames) {
    std::vector<std::size_t> order(frames.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto is_earlier = [&frames](std::size_t one, std::size_t other) {
        return frames[one].receive_time < frames[other].receive_time ||
               (frames[one].receive_time == frames[other].receive_time && one < other);
    };
    if (std::is_sorted(order.begin(), order.end(), is_earlier)) {
        return;
    }
    std::sort(order.begin(), order.end(), is_earlier);
    std::vector<rsi::hal::CanFrame> sorted;
    sorted.reserve(frames.size());
    for (const std::size_t place : order) {
        sorted.push_back(frames[place]);
    }
    frames = std::move(sorted);
}

}  // namespace

std::vector<rsi::hal::CanFrame> replayable_frames(const std::vector<LoggedFrame>& log) {
    std::vector<rsi::hal::CanFrame> frames;
    rsi::hal::Time latest{};
    for (const LoggedFrame& logged : log) {
        if (!is_sensor_frame(logged.frame)) {
            continue;
        }
        const rsi::hal::Time time = logged.frame.receive_time;
        latest = frames.empty() ? time : latest;
        if (longest_disorder < latest - time) {
            throw ReplayError{
                logged.line,
                fmt::format("the time goes back from {:.6f} s to {:.6f} s, further than recorders of several "
                            "buses write it: two recordings, or a clock that was set; cut the log before "
                            "this line, or sort it by time",
                            seconds(latest), seconds(time))};
        }
        if (longest_gap < time - latest) {
            throw ReplayError{
                logged.line,
                fmt::format(
                    "a gap of {:.0f} s between two sensor frames; cut the recording in two before this line",
                    seconds(time - latest))};
        }
        latest = latest < time ? time : latest;
        if (!frames.empty() && longest_log < time - frames.front().receive_time) {
            throw ReplayError{logged.line,
                              fmt::format("the log is longer than {:.0f} h; cut it in two before this line",
                                          seconds(longest_log) / 3600.0)};
        }
        frames.push_back(logged.frame);
    }
    if (frames.empty()) {
        refuse_without_sensor_frames();
    }
    sort_by_time(frames);
    return frames;
}

std::vector<LoggedFrame> replay(const std::vector<LoggedFrame>& log, const rsi::Parameters& parameters) {
    std::vector<LoggedFrame> answers;
    const std::vector<rsi::hal::CanFrame> frames = replayable_frames(log);
    InProcessEcu ecu{parameters};
    rsi::hal::FrameReplay player{frames.data(), frames.size(), ecu.clock(), ecu.world_bus()};
    rsi::hal::CanFrame frame;
    for (rsi::hal::Time time = frames.front().receive_time;; time = time + cycle_time) {
        player.run_until(time);
        ecu.step();
        while (ecu.world_bus().receive(frame) == rsi::hal::ReceiveResult::frame) {
            answers.push_back(LoggedFrame{frame, log.front().interface});
        }
        if (player.finished()) {
            return answers;
        }
    }
}

}  // namespace sil
