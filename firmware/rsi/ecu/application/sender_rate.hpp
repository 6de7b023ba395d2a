// Sender rate: whether more frames come with an identifier than its one sender sends.
#pragma once

#include <cstdint>

namespace rsi::application {

// A second sender of the same identifier raises the frame rate, whatever its counter and checksums. The
// surplus is the time that the frames of all cycles would take if each took a little less than its 10 ms,
// less the time of the cycles. One sender keeps it at its lower end; a second one of the same rate fills it
// within 0.12 s; one that sends every 80 ms takes some seconds, and a rarer one is not seen. By cycles,
// because some drivers know no times of reception, and a clock may jump.
//
// Frames that were held up, on the bus or before a cycle that came late, are no second sender's:
// - they come in bursts, so a cycle counts a few at most, however many it reads;
// - cycles without a frame were before them, or missed ones, which are not forgotten until they are through.
class SenderRate {
 public:
    // One frame. A cycle has no more than 254.
    void count() noexcept { ++frames_; }

    // Number of cycles left out before this one.
    void miss(std::uint32_t cycles) noexcept;

    // Before the first frame of the next cycle. False when nothing has changed, as in nearly every cycle;
    // this is the path that must be cheap.
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
    static constexpr std::int32_t least_ms = -320;
    static constexpr std::uint8_t none = 255U;

    [[gnu::cold]] void update() noexcept;

    std::int16_t surplus_ms_{least_ms};  // frames may wait at the start
    std::uint8_t frames_{0U};            // of this cycle
    std::uint8_t settled_frames_{none};  // another cycle with so many changes nothing
    bool paused_{true};                  // the cycle before this one had no frame, or was missed
    bool doubled_{false};
};

}  // namespace rsi::application
