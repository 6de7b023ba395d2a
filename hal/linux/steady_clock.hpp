// Steady clock: CLOCK_MONOTONIC, which cannot be set and never goes back.
#pragma once

#include "rsi/hal/clock.hpp"

namespace rsi::hal {

class SteadyClock final : public Clock {
 public:
    SteadyClock() noexcept = default;

    Time now() const noexcept override;

    // Sleeps until `deadline` on this clock, through signals; returns at once when it has passed.
    // An absolute deadline does not drift, whatever the time between two calls.
    void wait_until(Time deadline) const noexcept;
};

}  // namespace rsi::hal
