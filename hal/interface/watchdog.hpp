// Watchdog: resets the controller unless it is fed in time.
#pragma once

namespace hal {

class Watchdog {
 public:
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    // Called once after each healthy step, and never otherwise.
    virtual void feed() noexcept = 0;

 protected:
    Watchdog() = default;
    ~Watchdog() = default;
};

}  // namespace hal
