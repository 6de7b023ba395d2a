// ISO-TP (ISO 15765-2): messages longer than a frame, on classic CAN with normal addressing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/ecu/diagnosis/message.hpp"
#include "rsi/hal/can_bus.hpp"
#include "rsi/hal/frame_listener.hpp"

namespace rsi::diagnosis {

// 11-bit identifiers. A platform lets the two requests through its acceptance filters. An integration that
// has others says so here and nowhere else.
struct Addresses {
    std::uint32_t physical_request{0x7A6U};    // to this control unit alone
    std::uint32_t functional_request{0x7DFU};  // to every control unit
    std::uint32_t response{0x7AEU};
};

// One request at a time in each of the two ways of addressing, and one response. A functional request is one
// frame, held apart: it does not disturb a segmented request that is on its way. Requests are not taken while
// one waits or a response goes out: the tester sends after the answer.
class IsoTp final : public hal::FrameListener {
 public:
    static constexpr std::size_t longest_request = 130U;

    // `bus` must outlive this object.
    IsoTp(hal::CanBus& bus, const Addresses& addresses) noexcept : bus_{bus}, addresses_{addresses} {}

    // Any frame of the bus; foreign ones are left alone.
    void take(const hal::CanFrame& frame) noexcept override;

    // The request that waits; length 0: none does. It stays until it is finished. If one of each kind
    // waits, they take turns, so that neither keeps the other waiting.
    Request request() const noexcept;
    void finish(const Request& request) noexcept;
    void drop_functional() noexcept { functional_length_ = 0U; }

    // Only while it is not sending. `response` has a byte at least, and neither moves nor changes while
    // is_sending().
    void send(const Response& response) noexcept;
    bool is_sending() const noexcept { return sending_ != Sending::nothing; }
    // A segmented request is on its way.
    bool is_receiving() const noexcept { return is_receiving_; }

    // Something is on its way or waits, in either direction.
    bool is_active() const noexcept { return is_active_; }

    // Once a cycle of 10 ms while it is active: sends what is due and counts the times.
    void end_cycle() noexcept;

 private:
    enum class Sending : std::uint8_t { nothing, first_frame, waiting_for_flow_control, consecutive_frames };
    enum class FlowStatus : std::uint8_t { continue_to_send = 0U, wait = 1U, overflow = 2U, none = 0xFFU };
    using Payload = std::array<std::uint8_t, 8>;

    void take_functional(const hal::CanFrame& frame) noexcept;
    void take_physical(const hal::CanFrame& frame) noexcept;
    void take_new(const hal::CanFrame& frame) noexcept;
    void take_single(const hal::CanFrame& frame) noexcept;
    void take_first(const hal::CanFrame& frame) noexcept;
    void take_consecutive(const hal::CanFrame& frame) noexcept;
    void take_flow_control(const hal::CanFrame& frame) noexcept;
    void take_bytes(const hal::CanFrame& frame, std::size_t from, std::size_t count) noexcept;
    std::size_t left_to_send() const noexcept { return response_->length() - sent_; }
    void fill(Payload& payload, std::size_t from, std::size_t count) const noexcept;
    bool send_frame(const Payload& payload) noexcept;
    void send_flow_control() noexcept;
    void send_response() noexcept;
    void send_first() noexcept;
    void send_consecutive() noexcept;
    void count_sent(std::size_t bytes) noexcept;

    hal::CanBus& bus_;
    Addresses addresses_;

    std::array<std::uint8_t, longest_request> physical_{};
    std::size_t physical_length_{0U};  // of the request that is on its way or waits
    std::size_t received_{0U};
    std::uint32_t receive_cycles_{0U};  // since the last frame of it
    std::uint8_t next_received_{0U};    // sequence number
    bool is_receiving_{false};
    bool is_active_{false};  // may be
    bool physical_waits_{false};
    FlowStatus flow_control_due_{FlowStatus::none};

    std::array<std::uint8_t, 7> functional_{};
    std::size_t functional_length_{0U};  // 0: none waits
    bool was_functional_{false};         // the request finished last

    const Response* response_{nullptr};
    std::size_t sent_{0U};
    std::uint32_t send_cycles_{0U};  // since the last progress
    std::uint32_t gap_{0U};          // cycles to the next frame
    std::uint32_t separation_{0U};   // cycles from one frame to the next; 0: as many as may be sent in one
    std::uint8_t block_left_{0U};    // frames until the next flow control; 0 at its beginning: no limit
    std::uint8_t waits_{0U};         // flow controls that said "wait"
    bool block_is_limited_{false};
    std::uint8_t next_sent_{0U};
    Sending sending_{Sending::nothing};
};

}  // namespace rsi::diagnosis
