// Recorded frames: a bus that takes every frame and keeps it.
#pragma once

#include <vector>

#include "hal/interface/can_bus.hpp"

namespace faults_test {

class RecordedFrames final : public hal::CanBus {
 public:
    hal::ReceiveResult receive(hal::CanFrame& frame) noexcept override {
        if (next_ == frames.size()) {
            return hal::ReceiveResult::empty;
        }
        frame = frames[next_++];
        return hal::ReceiveResult::frame;
    }
    hal::SendResult send(const hal::CanFrame& frame) noexcept override {
        frames.push_back(frame);
        return hal::SendResult::sent;
    }
    hal::BusState state() const noexcept override { return hal::BusState::error_active; }
    hal::BusStatistics statistics() const noexcept override { return {}; }

    std::vector<hal::CanFrame> frames{};

 private:
    std::size_t next_{0U};
};

}  // namespace faults_test
