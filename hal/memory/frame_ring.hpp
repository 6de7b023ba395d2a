// Frame ring: a first-in, first-out queue of frames with a fixed capacity. It carries
// the bytes that a frame has, and no more than a classic frame's eight beside them.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>

#include "rsi/hal/can_bus.hpp"

namespace rsi::hal {

template <std::size_t capacity>
class FrameRing {
    static_assert(capacity > 0U);

 public:
    // False when there is no room; the frame is then dropped, as a controller's full mailbox does.
    bool push(const CanFrame& frame) noexcept {
        if (size_ == capacity) {
            return false;
        }
        copy(frame, frames_[(first_ + size_) % capacity]);
        ++size_;
        return true;
    }

    // False when nothing is waiting; `frame` is then left alone.
    bool pop(CanFrame& frame) noexcept {
        if (size_ == 0U) {
            return false;
        }
        copy(frames_[first_], frame);
        first_ = (first_ + 1U) % capacity;
        --size_;
        return true;
    }

    std::size_t size() const noexcept { return size_; }

 private:
    // `length` is at most 64: a bus takes well-formed frames only.
    static void copy(const CanFrame& from, CanFrame& to) noexcept {
        to.identifier = from.identifier;
        to.extended = from.extended;
        to.flexible_data_rate = from.flexible_data_rate;
        to.length = from.length;
        to.receive_time = from.receive_time;
        if (from.length <= classic_bytes) {
            std::memcpy(to.data.data(), from.data.data(), classic_bytes);  // a known size needs no call
        } else {
            std::memcpy(to.data.data(), from.data.data(), from.length);
        }
    }

    static constexpr std::size_t classic_bytes = 8U;  // the most that a frame of classic CAN has

    std::array<CanFrame, capacity> frames_{};
    std::size_t first_{0U};
    std::size_t size_{0U};
};

}  // namespace rsi::hal
