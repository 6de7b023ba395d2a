// Sender rate: whether more frames come with an identifier than its one sender sends.
#pragma once

#include <algorithm>
#include <cstdint>

#include "hal/interface/clock.hpp"

namespace application {

// Whoever sends a second time what a sensor sends, with good checksums and whatever counter, cannot hide that
// more frames come. The surplus is what the frames would take if each took a little less than its 10 ms, less
// the time in which they came. One sender keeps it at its lower end; a second one of the same rate fills it
// within 0.12 s; one that sends every 80 ms takes some seconds, and a rarer one is not seen.
//
// Frames that were held up, on the bus or before a cycle that came late, are no second sender's:
// - they come in bursts, so a cycle counts a few at most, however many it reads;
// - a gap was before them, which is not forgotten until they are through.
class SenderRate {
 public:
    // One frame.
    void count(hal::Time received) noexcept {
        newest_ = ticks_of(received);
        frames_ = (frames_ < most_frames) ? static_cast<std::uint8_t>(frames_ + 1U) : most_frames;
    }

    // Before the first frame of the next cycle.
    void end_cycle() noexcept {
        if (frames_ == 0U) {
            return;
        }
        const std::uint32_t elapsed = newest_ - previous_;
        surplus_ = static_cast<std::int16_t>(is_known(elapsed) ? surplus_after(elapsed) : least);
        doubled_ = (surplus_ == most) || (doubled_ && (surplus_ > 0));
        previous_ = newest_;
        frames_ = 0U;
    }

    bool is_doubled() const noexcept { return doubled_; }

 private:
    // A power of two of nanoseconds. The ticks come round after three days.
    static constexpr std::uint32_t ticks_of(hal::Time time) noexcept {
        return static_cast<std::uint32_t>(time.nanoseconds >> 16U);
    }
    static constexpr std::int32_t ns_per_tick = 65'536;
    static constexpr std::int32_t ns_per_ms = 1'000'000;

    static constexpr std::int32_t time_of_a_frame = 9 * ns_per_ms / ns_per_tick;
    static constexpr std::uint8_t most_frames = 4U;  // that a cycle counts
    static constexpr std::uint8_t most_usual_frames = 2U;
    static constexpr std::int32_t longest_usual = 35 * ns_per_ms / ns_per_tick;
    static constexpr std::int32_t longest_gap = 320 * ns_per_ms / ns_per_tick;
    static constexpr std::int32_t least = -longest_gap;
    static constexpr std::int32_t usual_least = -20 * ns_per_ms / ns_per_tick;
    static constexpr std::int32_t most = 60 * ns_per_ms / ns_per_tick;

    // After a longer silence, and by a clock that stands or goes back, all may have been held up.
    static constexpr bool is_known(std::uint32_t elapsed) noexcept {
        return (elapsed > 0U) && (elapsed <= static_cast<std::uint32_t>(longest_gap));
    }

    std::int32_t surplus_after(std::uint32_t known) const noexcept {
        const auto elapsed = static_cast<std::int32_t>(known);
        const bool is_usual = (frames_ <= most_usual_frames) && (elapsed <= longest_usual);
        return std::clamp(surplus_ + frames_ * time_of_a_frame - elapsed, is_usual ? usual_least : least, most);
    }

    std::uint32_t newest_{0U};    // time of the newest frame of this cycle
    std::uint32_t previous_{0U};  // of that of the cycle before it that had any
    std::int16_t surplus_{usual_least};
    std::uint8_t frames_{0U};  // of this cycle
    bool doubled_{false};
};

}  // namespace application
