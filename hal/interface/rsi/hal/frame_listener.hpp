// Frame listener: who else hears what a control unit receives.
#pragma once

#include "rsi/hal/can_bus.hpp"

namespace rsi::hal {

class FrameListener {
 public:
    FrameListener(const FrameListener&) = delete;
    FrameListener& operator=(const FrameListener&) = delete;

    // Called within a cycle, so it returns at once: what takes longer is done after the step.
    virtual void take(const CanFrame& frame) noexcept = 0;

 protected:
    FrameListener() = default;
    ~FrameListener() = default;
};

}  // namespace rsi::hal
