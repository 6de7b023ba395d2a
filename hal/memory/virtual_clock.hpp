// Virtual clock: time that stands still until its owner moves it, for tests and lock-step runs.
#pragma once

#include "rsi/hal/clock.hpp"

namespace rsi::hal {

class VirtualClock final : public Clock {
 public:
    explicit VirtualClock(Time start = Time{}) noexcept : now_(start) {}

    Time now() const noexcept override { return now_; }

    // Moves the clock to `time`. A clock never goes back: an earlier time changes nothing and returns false.
    bool set(Time time) noexcept {
        if (time < now_) {
            return false;
        }
        now_ = time;
        return true;
    }

    // Moves the clock on by `duration`; a negative one changes nothing and returns false.
    bool advance(Time duration) noexcept { return set(now_ + duration); }

 private:
    Time now_;
};

}  // namespace rsi::hal
