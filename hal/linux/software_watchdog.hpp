// Software watchdog: stands in for the controller's watchdog on a host, which it cannot reset.
#pragma once

#include "rsi/hal/clock.hpp"
#include "rsi/hal/watchdog.hpp"

namespace rsi::hal {

// Expires when more than `limit` passes between two feedings, or between construction and the first one. Like
// a controller that has been reset, it stays expired; feeding comes too late then. The main loop asks
// expired() once a cycle and ends the program, so that its supervisor can restart it. It lives in the
// loop that it watches: it notices a step that was unhealthy or late, but a loop that never returns needs a
// supervisor outside the process.
class SoftwareWatchdog final : public Watchdog {
 public:
    // `clock` must outlive the watchdog.
    SoftwareWatchdog(const Clock& clock, Time limit) noexcept
        : clock_(clock), limit_(limit), last_feeding_(clock.now()) {}

    void feed() noexcept override {
        if (!expired()) {
            last_feeding_ = clock_.now();
        }
    }

    // Whether it has expired, by now or earlier.
    bool expired() noexcept {
        expired_ = expired_ || limit_ < clock_.now() - last_feeding_;
        return expired_;
    }

    // The last feeding that came in time, or the construction.
    Time last_feeding() const noexcept { return last_feeding_; }

 private:
    const Clock& clock_;
    Time limit_;
    Time last_feeding_;
    bool expired_{false};
};

}  // namespace rsi::hal
