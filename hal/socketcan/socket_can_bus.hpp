// SocketCAN bus: a Linux CAN interface (can0, vcan0, ...) behind hal::CanBus.
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/socketcan/can_socket.hpp"
#include "hal/socketcan/controller_restart.hpp"
#include "hal/socketcan/open_result.hpp"
#include "rsi/hal/bus_off_schedule.hpp"
#include "rsi/hal/can_bus.hpp"

namespace rsi::hal {

struct CanIdentifier {
    std::uint32_t value{0U};  // 11 bits, or 29 bits when `extended`
    bool extended{false};
};

struct SocketCanSettings {
    const char* interface_name{"can0"};
    // Only these identifiers are let through, by the kernel; none given means all. Up to 64; copied by
    // open().
    const CanIdentifier* identifiers{nullptr};
    std::size_t identifier_count{0U};
    int receive_buffer_bytes{1 << 20};  // room for about a thousand frames, as the kernel counts them
    bool receive_own_frames{false};     // whether what this bus sends comes back to it
    bool bit_rate_switch{true};         // send CAN FD payloads at the faster bit rate
    bool restart_when_bus_off{false};   // by BusOffSchedule; needs the right to configure interfaces
};

// Counted since the bus was opened.
struct BusOffReport {
    std::uint32_t times{0U};
    std::uint32_t restarts{0U};
    int refusal{0};  // errno of the last restart that the kernel refused, 0 when the last one was not
};

// After open(), no call allocates, blocks or throws, except wait_for_frame(), which is made to block.
//
// Receive times are the kernel's stamps, on CLOCK_MONOTONIC, the clock of SteadyClock.
// frames_lost counts what the socket's receive buffer could not hold (the kernel reports a loss with the next
// frame that it queues, so the count is complete once a later frame has been received) and the controller's
// own overflows. The state follows the kernel's error frames, which receive() reads in passing: call
// receive() every cycle. When the interface goes down or vanishes, the state is `closed` and both calls fail;
// at most every 100 ms they look whether it is up again, and then go on by themselves, with a vanished one
// made anew under the same name as well.
//
// With restart_when_bus_off, a controller that is bus-off is restarted from receive(), unless the interface
// has a `restart-ms`, with which the kernel does that. This is the one thing for which receive() may take
// longer: as long as the driver needs for it.
class SocketCanBus final : public CanBus {
 public:
    SocketCanBus() noexcept = default;
    ~SocketCanBus();

    // Opens the interface; an earlier one is closed first and the statistics start at zero.
    // The result says what is wrong, where, and what to do next.
    OpenResult open(const SocketCanSettings& settings) noexcept;
    void close() noexcept;

    ReceiveResult receive(CanFrame& frame) noexcept override;
    SendResult send(const CanFrame& frame) noexcept override;
    BusState state() const noexcept override { return state_; }
    BusStatistics statistics() const noexcept override { return statistics_; }
    BusOffReport bus_off_report() const noexcept { return bus_off_; }

    // Blocks until a frame or an error waits, for at most `longest` (rounded up to milliseconds).
    // True when receive() has something to look at. For programs that are driven by frames instead of by a
    // tick.
    bool wait_for_frame(Time longest) const noexcept;

    // The kernel's accounting size of the receive buffer, which it makes twice what it was asked for; 0 when
    // closed.
    int receive_buffer_bytes() const noexcept;

 private:
    ReceiveResult after_read_error(int system_error) noexcept;
    void take_sign_of_life() noexcept;
    void follow_bus_off() noexcept;
    void take_error_frame(const canfd_frame& error_frame) noexcept;
    void take_drop_count(std::uint32_t drop_count) noexcept;
    Time receive_time_of(const ReadResult& read) const noexcept;
    SendResult send_failed(SendResult result) noexcept;
    void lose_interface(int system_error) noexcept;
    bool is_usable() noexcept;
    bool try_recovery() noexcept;

    CanSocketSettings settings_;
    BusStatistics statistics_;
    BusState state_{BusState::closed};
    int descriptor_{-1};
    bool is_open_{false};  // between open() and close(), whatever the interface does
    bool vanished_{false};
    bool bit_rate_switch_{true};
    bool restart_when_bus_off_{false};
    BusOffReport bus_off_;
    BusOffSchedule bus_off_schedule_;
    bool left_to_kernel_{false};
    Time restart_at_{};
    std::uint32_t drop_count_{0U};
    Time last_empty_{};
    Time next_recovery_{};
};

}  // namespace rsi::hal
