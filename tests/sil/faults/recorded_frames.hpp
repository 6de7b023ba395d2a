// Recorded frames: a bus that takes every frame and keeps it.
#pragma once

#include <vector>

#include "rsi/hal/can_bus.hpp"

namespace faults_test {

class RecordedFrames final : public rsi::hal::CanBus {
 public:
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame& frame) noexcept override {
        if (next_ == frames.size()) {
            return rsi::hal::ReceiveResult::empty;
        }
        frame = frames[next_++];
        return rsi::hal::ReceiveResult::frame;
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override {
        frames.push_back(frame);
        return rsi::hal::SendResult::sent;
    }
    rsi::hal::BusState state() const noexcept override { return rsi::hal::BusState::error_active; }
    rsi::hal::BusStatistics statistics() const noexcept override { return {}; }

    std::vector<rsi::hal::CanFrame> frames{};

 private:
    std::size_t next_{0U};
};

}  // namespace faults_test
