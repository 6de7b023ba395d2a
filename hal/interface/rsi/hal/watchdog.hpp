// Watchdog: resets the controller unless it is fed in time.
#pragma once

namespace rsi::hal {

class Watchdog {
 public:
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    // Called once after each step that ran to its end. A step that finds its inputs or parameters bad has run
    // to its end: it has said so on the bus, and a reset would not help. One that finds its own memory
    // damaged does not feed: a reset does help.
    virtual void feed() noexcept = 0;

 protected:
    Watchdog() = default;
    ~Watchdog() = default;
};

}  // namespace rsi::hal
