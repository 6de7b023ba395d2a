// Frame replay: sends recorded frames at their recorded times, moving the virtual clock as it goes.
#pragma once

#include <cstddef>

#include "hal/memory/virtual_clock.hpp"
#include "rsi/hal/can_bus.hpp"

namespace rsi::hal {

// Plays `frames` (count of them, in order of `receive_time`, which says when each is due) onto one endpoint
// of a MemoryBus. The clock stands at a frame's own time when the frame is sent, so that receivers see the
// recorded time stamp. Frames of the others are read from the same endpoint. The sequence, clock and bus must
// outlive the replay.
class FrameReplay {
 public:
    FrameReplay(const CanFrame* frames, std::size_t count, VirtualClock& clock, CanBus& bus) noexcept
        : frames_(frames), count_(count), clock_(clock), bus_(bus) {}

    // Sends every frame that is due at or before `time`, then moves the clock to `time`.
    // Returns the number of frames sent now. A frame older than the clock is sent at once.
    std::size_t run_until(Time time) noexcept {
        std::size_t sent = 0U;
        for (; next_ < count_ && !(time < frames_[next_].receive_time); ++next_) {
            clock_.set(frames_[next_].receive_time);
            if (bus_.send(frames_[next_]) == SendResult::sent) {
                ++sent;
            }
        }
        clock_.set(time);
        return sent;
    }

    bool finished() const noexcept { return next_ == count_; }

 private:
    const CanFrame* frames_;
    std::size_t count_;
    VirtualClock& clock_;
    CanBus& bus_;
    std::size_t next_{0U};
};

}  // namespace rsi::hal
