#include "sil/simulation/replay.hpp"

#include <algorithm>

#include "application/sensor_reception.hpp"
#include "hal/memory/frame_replay.hpp"
#include "sil/simulation/in_process_ecu.hpp"
#include "sil/simulation/pace.hpp"

namespace sil {
namespace {

bool is_sensor_frame(const LoggedFrame& logged) {
    const auto& known = application::received_identifiers;
    return std::find(known.begin(), known.end(), logged.frame.identifier) != known.end();
}

std::vector<hal::CanFrame> sensor_frames(const std::vector<LoggedFrame>& log) {
    std::vector<hal::CanFrame> frames;
    for (const LoggedFrame& logged : log) {
        if (is_sensor_frame(logged)) {
            frames.push_back(logged.frame);
        }
    }
    return frames;
}

}  // namespace

std::vector<LoggedFrame> replay(const std::vector<LoggedFrame>& log, const rsi::Parameters& parameters) {
    std::vector<LoggedFrame> answers;
    const std::vector<hal::CanFrame> frames = sensor_frames(log);
    if (frames.empty()) {
        return answers;
    }
    InProcessEcu ecu{parameters};
    hal::FrameReplay player{frames.data(), frames.size(), ecu.clock(), ecu.world_bus()};
    hal::CanFrame frame;
    for (hal::Time time = frames.front().receive_time;; time = time + cycle_time) {
        player.run_until(time);
        ecu.step();
        while (ecu.world_bus().receive(frame) == hal::ReceiveResult::frame) {
            answers.push_back(LoggedFrame{frame, log.front().interface, 0U});
        }
        if (player.finished()) {
            return answers;
        }
    }
}

}  // namespace sil
