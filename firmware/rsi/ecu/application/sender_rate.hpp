// Sender rate: detects a second sender of an identifier by its frame rate.
#pragma once

#include <cstdint>

namespace rsi::application {

// A second sender raises the frame rate, whatever its counter and checksums. The detector is a leaky bucket:
// each frame adds 9 ms (a little less than its period of 10 ms), each cycle takes 10 ms away. One sender
// keeps the surplus at its lower end. A second one of the same rate fills it within 0.12 s, one that sends
// every 80 ms within some seconds; a slower one is not detected. It counts cycles instead of using receive
// times, because some drivers have none and a clock may jump.
//
// Bursts of frames that were delayed, on the bus or by a late cycle, must not count as a second sender:
// - a cycle counts a few frames at most, however many it reads;
// - the empty or missed cycles before the burst lower the surplus beyond its usual end, as far as the burst
// raises it.
class SenderRate {
 public:
    // One frame. Precondition: at most 254 a cycle.
    void count() noexcept { ++frames_; }

    // Number of cycles left out before this one.
    void miss(std::uint32_t cycles) noexcept;

    // Before the first frame of the next cycle. False when nothing has changed: nearly every cycle takes this
    // path, so it is kept cheap.
    bool end_cycle() noexcept {
        const bool changes = (frames_ != settled_frames_);
        if (changes) {
            update();
        }
        frames_ = 0U;
        return changes;
    }

    bool is_doubled() const noexcept { return doubled_; }

 private:
    static constexpr std::int32_t least_ms = -320;  // lower end: remembers a pause of up to 320 ms
    static constexpr std::uint8_t none = 255U;      // no settled number of frames

    [[gnu::cold]] void update() noexcept;

    std::int16_t surplus_ms_{least_ms};  // frames may be waiting at the start
    std::uint8_t frames_{0U};            // in this cycle
    std::uint8_t settled_frames_{none};  // a cycle with this many frames changes nothing
    bool paused_{true};                  // the cycle before this one had no frame, or was missed
    bool doubled_{false};
};

}  // namespace rsi::application
