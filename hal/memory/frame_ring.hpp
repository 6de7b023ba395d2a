// Frame ring: a first-in, first-out queue of frames with a fixed capacity.
#pragma once

#include <array>
#include <cstddef>

#include "hal/interface/can_bus.hpp"

namespace hal {

template <std::size_t capacity>
class FrameRing {
    static_assert(capacity > 0U);

 public:
    // False when there is no room; the frame is then dropped, as a controller's full mailbox does.
    bool push(const CanFrame& frame) noexcept {
        if (size_ == capacity) {
            return false;
        }
        frames_[(first_ + size_) % capacity] = frame;
        ++size_;
        return true;
    }

    // False when nothing is waiting; `frame` is then left alone.
    bool pop(CanFrame& frame) noexcept {
        if (size_ == 0U) {
            return false;
        }
        frame = frames_[first_];
        first_ = (first_ + 1U) % capacity;
        --size_;
        return true;
    }

    std::size_t size() const noexcept { return size_; }

 private:
    std::array<CanFrame, capacity> frames_{};
    std::size_t first_{0U};
    std::size_t size_{0U};
};

}  // namespace hal
