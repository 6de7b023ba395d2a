// Pace: how simulated time runs, and how the world waits for the ECU's answer.
#pragma once

#include <cstdint>

#include "rsi/hal/can_bus.hpp"

namespace sil {

inline constexpr double cycle_time_s = 0.01;
inline constexpr rsi::hal::Time cycle_time = rsi::hal::Time::from_milliseconds(10);

class Pace {
 public:
    Pace(const Pace&) = delete;
    Pace& operator=(const Pace&) = delete;

    // Before the frames of cycle `number` are sent. Simulated time is then number * 10 ms.
    virtual void begin_cycle(std::uint32_t number) = 0;

    // After they were sent.
    virtual void frames_sent(std::uint32_t number) = 0;

    // Called when no frame waits and the ECU's status frame of this cycle has not arrived. True: read the bus
    // again; false: end the cycle without it.
    virtual bool wait_for_answer(std::uint32_t number) = 0;

    // Simulated time at which a frame was received.
    virtual double reception_time_s(const rsi::hal::CanFrame& frame) const = 0;

 protected:
    Pace() = default;
    ~Pace() = default;
};

}  // namespace sil
