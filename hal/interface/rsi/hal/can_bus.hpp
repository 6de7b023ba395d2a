// CAN bus: what a platform must give so that an application can receive and send frames.
#pragma once

#include <array>
#include <cstdint>

#include "rsi/hal/clock.hpp"

namespace rsi::hal {

// One data frame, classic (up to 8 bytes) or CAN FD (up to 64). Error and remote frames never reach an
// application.
struct CanFrame {
    std::uint32_t identifier{0U};  // 11 bits, or 29 bits when `extended`
    bool extended{false};
    bool flexible_data_rate{false};
    std::uint8_t length{0U};  // payload bytes, 0 to 8 (classic) or 0 to 64 (CAN FD)
    std::array<std::uint8_t, 64> data{};
    Time receive_time{};  // on the platform's Clock; ignored when sending
};

enum class ReceiveResult : std::uint8_t {
    frame,   // a frame was stored
    empty,   // nothing is waiting
    failed,  // the bus cannot be read at present; see state()
};

enum class SendResult : std::uint8_t {
    sent,    // the controller has taken the frame
    full,    // no room at present; the frame was not sent
    failed,  // the bus cannot be written at present; see state()
};

// Fault confinement as ISO 11898-1 names it, and `closed` for an interface that is gone or down.
enum class BusState : std::uint8_t { error_active, error_passive, bus_off, closed };

// Counted since the bus was opened; each saturates at its largest value.
struct BusStatistics {
    std::uint32_t frames_received{0U};
    std::uint32_t frames_sent{0U};
    std::uint32_t frames_lost{0U};  // received by the controller or the driver, but dropped for want of room
    std::uint32_t error_frames{0U};
    std::uint32_t send_failures{0U};  // sends that ended in `full` or `failed`
};

// No call blocks, allocates or throws.
class CanBus {
 public:
    CanBus(const CanBus&) = delete;
    CanBus& operator=(const CanBus&) = delete;

    // Takes the oldest waiting frame. `frame` is written only when the result is `frame`.
    virtual ReceiveResult receive(CanFrame& frame) noexcept = 0;

    // Hands one frame to the controller.
    virtual SendResult send(const CanFrame& frame) noexcept = 0;

    virtual BusState state() const noexcept = 0;
    virtual BusStatistics statistics() const noexcept = 0;

 protected:
    CanBus() = default;
    ~CanBus() = default;  // never deleted through this interface, so no virtual destructor and no heap
};

}  // namespace rsi::hal
