// Lock-step pace: simulated time stands still until the ECU has answered.
#pragma once

#include <stdexcept>

#include "hal/socketcan/socket_can_bus.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/simulation/recorded_bus.hpp"
#include "sil/simulation/sensor_frames.hpp"

namespace sil {

// Ends each cycle's sensor frames with SimulationSync; the ECU's status frame, the last of its answer, ends
// the cycle.
class LockStepPace final : public Pace {
 public:
    // `bus` is `socket` as the run sees it, with a log that gets simulated time. All must outlive the pace.
    LockStepPace(hal::SocketCanBus& socket, RecordedBus& bus) : socket_{socket}, bus_{bus} {}

    void begin_cycle(std::uint32_t number) override {
        number_ = number;
        bus_.set_time(hal::Time{number * cycle_time.nanoseconds});
    }

    void frames_sent(std::uint32_t number) override { SensorFrames::send_sync(bus_, number); }

    bool wait_for_answer(std::uint32_t) override {
        if (!socket_.wait_for_frame(longest_wait)) {
            throw std::runtime_error(
                "no answer from the ECU within 5 s. Is `rsi-ecu --lock-step` running on the same interface?");
        }
        return true;
    }

    double reception_time_s(const hal::CanFrame&) const override { return number_ * cycle_time_s; }

 private:
    static constexpr hal::Time longest_wait = hal::Time::from_milliseconds(5000);

    hal::SocketCanBus& socket_;
    RecordedBus& bus_;
    std::uint32_t number_{0U};
};

}  // namespace sil
