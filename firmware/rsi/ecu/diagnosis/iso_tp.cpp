#include "rsi/ecu/diagnosis/iso_tp.hpp"

namespace rsi::diagnosis {
namespace {

constexpr std::uint8_t padding = 0xCCU;  // few stuff bits
constexpr std::array<std::uint8_t, 8> padded{padding, padding, padding, padding,
                                             padding, padding, padding, padding};
constexpr std::uint32_t time_out_cycles = 100U;  // N_As, N_Bs, N_Cr: 1 s
constexpr std::uint8_t most_waits = 10U;
// Share of the bus for a response in a cycle, in which the control unit sends eight frames of its own.
constexpr std::uint32_t most_frames_per_cycle = 4U;

// The upper half of the first byte.
constexpr std::uint32_t single_frame = 0x0U;
constexpr std::uint32_t first_frame = 0x1U;
constexpr std::uint32_t consecutive_frame = 0x2U;
constexpr std::uint32_t flow_control = 0x3U;

constexpr std::size_t first_bytes = 6U;
constexpr std::size_t bytes_per_frame = 7U;

std::uint32_t kind_of(const hal::CanFrame& frame) {
    return std::uint32_t{frame.data[0]} >> 4U;
}

std::uint8_t low_half(std::uint8_t byte) {
    return static_cast<std::uint8_t>(byte & 0x0FU);
}

// 0 where the frame is no good single frame.
std::size_t single_length(const hal::CanFrame& frame) {
    const std::size_t length = low_half(frame.data[0]);
    return (length < frame.length) ? length : 0U;
}

// STmin as cycles from one frame to the next: a whole number of cycles may be a moment too short, so one
// more. 0xF1 to 0xF9 are 0.1 to 0.9 ms; what is reserved counts as the longest.
std::uint32_t cycles_of_separation(std::uint8_t separation_time) {
    if (separation_time == 0U) {
        return 0U;
    }
    if ((separation_time >= 0xF1U) && (separation_time <= 0xF9U)) {
        return 1U;
    }
    const std::uint32_t milliseconds = (separation_time <= 0x7FU) ? separation_time : 0x7FU;
    return milliseconds / 10U + 1U;
}

}  // namespace

void IsoTp::take(const hal::CanFrame& frame) noexcept {
    if (frame.extended || frame.flexible_data_rate || (frame.length == 0U) || (frame.length > 8U)) {
        return;
    }
    if (frame.identifier == addresses_.physical_request) {
        is_active_ = true;
        take_physical(frame);
    } else if (frame.identifier == addresses_.functional_request) {
        is_active_ = true;
        take_functional(frame);
    } else {
        // foreign traffic
    }
}

void IsoTp::take_functional(const hal::CanFrame& frame) noexcept {
    if ((kind_of(frame) != single_frame) || (functional_length_ != 0U)) {
        return;
    }
    functional_length_ = single_length(frame);
    for (std::size_t index = 0U; index < functional_.size(); ++index) {
        functional_[index] = frame.data[1U + index];
    }
}

void IsoTp::take_physical(const hal::CanFrame& frame) noexcept {
    const std::uint32_t kind = kind_of(frame);
    if (kind == flow_control) {
        take_flow_control(frame);
        return;
    }
    if (physical_waits_) {
        return;
    }
    if (kind == consecutive_frame) {
        take_consecutive(frame);  // also of a request that had begun before the answer to the functional one
    } else if (!is_sending()) {   // the tester speaks when he has been answered
        take_new(frame);
    } else {
        // too early
    }
}

void IsoTp::take_new(const hal::CanFrame& frame) noexcept {
    const std::uint32_t kind = kind_of(frame);
    if (kind == single_frame) {
        take_single(frame);
    } else if (kind == first_frame) {
        take_first(frame);
    } else {
        // reserved
    }
}

// Ends a segmented request that is on its way, as a first frame does: the tester has begun anew.
void IsoTp::take_single(const hal::CanFrame& frame) noexcept {
    const std::size_t length = single_length(frame);
    if (length == 0U) {
        return;
    }
    received_ = 0U;
    take_bytes(frame, 1U, length);
    physical_length_ = length;
    is_receiving_ = false;
    flow_control_due_ = FlowStatus::none;
    physical_waits_ = true;
}

void IsoTp::take_first(const hal::CanFrame& frame) noexcept {
    const std::size_t length = (std::size_t{low_half(frame.data[0])} << 8U) | frame.data[1];
    const bool is_longer_still = (length == 0U);  // than 4095: its length stands in four further bytes
    if ((frame.length < 8U) || (!is_longer_still && (length <= bytes_per_frame))) {
        return;
    }
    is_receiving_ = !is_longer_still && (length <= longest_request);
    flow_control_due_ = is_receiving_ ? FlowStatus::continue_to_send : FlowStatus::overflow;
    if (is_receiving_) {
        received_ = 0U;
        take_bytes(frame, 2U, first_bytes);
        physical_length_ = length;
        next_received_ = 1U;
        receive_cycles_ = 0U;
    }
}

void IsoTp::take_consecutive(const hal::CanFrame& frame) noexcept {
    if (!is_receiving_) {
        return;
    }
    const std::size_t left = physical_length_ - received_;
    const std::size_t carried = (left < bytes_per_frame) ? left : bytes_per_frame;
    if ((low_half(frame.data[0]) != next_received_) || (frame.length <= carried)) {
        is_receiving_ = false;  // a frame is missing, or is cut off
        return;
    }
    take_bytes(frame, 1U, carried);
    next_received_ = low_half(static_cast<std::uint8_t>(next_received_ + 1U));
    receive_cycles_ = 0U;
    physical_waits_ = (received_ == physical_length_);
    is_receiving_ = !physical_waits_;
}

void IsoTp::take_bytes(const hal::CanFrame& frame, std::size_t from, std::size_t count) noexcept {
    for (std::size_t index = 0U; index < count; ++index) {
        physical_[received_ + index] = frame.data[from + index];
    }
    received_ += count;
}

void IsoTp::take_flow_control(const hal::CanFrame& frame) noexcept {
    if ((sending_ != Sending::waiting_for_flow_control) || (frame.length < 3U)) {
        return;
    }
    const std::uint8_t status = low_half(frame.data[0]);
    if (status == static_cast<std::uint8_t>(FlowStatus::continue_to_send)) {
        block_left_ = frame.data[1];
        block_is_limited_ = (block_left_ != 0U);
        separation_ = cycles_of_separation(frame.data[2]);
        gap_ = 0U;
        waits_ = 0U;
        send_cycles_ = 0U;
        sending_ = Sending::consecutive_frames;
    } else if ((status == static_cast<std::uint8_t>(FlowStatus::wait)) && (waits_ < most_waits)) {
        ++waits_;
        send_cycles_ = 0U;
    } else {
        sending_ = Sending::nothing;  // the tester has no room, waits for ever, or sends an unknown status
    }
}

Request IsoTp::request() const noexcept {
    const bool physical_is_next = physical_waits_ && was_functional_;
    if ((functional_length_ != 0U) && !physical_is_next) {
        return Request{functional_.data(), functional_length_, true};
    }
    return Request{physical_.data(), physical_waits_ ? physical_length_ : 0U, false};
}

void IsoTp::finish(const Request& request) noexcept {
    was_functional_ = request.is_functional();
    if (request.is_functional()) {
        functional_length_ = 0U;
    } else {
        physical_waits_ = false;
    }
}

void IsoTp::send(const Response& response) noexcept {
    response_ = &response;
    sent_ = 0U;
    send_cycles_ = 0U;
    waits_ = 0U;
    sending_ = Sending::first_frame;
    is_active_ = true;
}

void IsoTp::end_cycle() noexcept {
    send_flow_control();
    if (is_receiving_) {
        ++receive_cycles_;
        is_receiving_ = (receive_cycles_ < time_out_cycles);
    }
    if (is_sending()) {
        send_response();
    }
    is_active_ = is_sending() || is_receiving_ || (flow_control_due_ != FlowStatus::none) ||
                 (request().length() != 0U);
}

bool IsoTp::send_frame(const Payload& payload) noexcept {
    hal::CanFrame frame{};
    frame.identifier = addresses_.response;
    frame.length = 8U;
    for (std::size_t index = 0U; index < payload.size(); ++index) {
        frame.data[index] = payload[index];
    }
    return bus_.send(frame) == hal::SendResult::sent;
}

// Every frame may follow the other at once: each is taken as it comes.
void IsoTp::send_flow_control() noexcept {
    if (flow_control_due_ == FlowStatus::none) {
        return;
    }
    Payload payload = padded;
    payload[1] = 0U;
    payload[2] = 0U;
    payload[0] =
        static_cast<std::uint8_t>((flow_control << 4U) | static_cast<std::uint8_t>(flow_control_due_));
    if (send_frame(payload)) {
        flow_control_due_ = FlowStatus::none;
    }
}

void IsoTp::send_response() noexcept {
    ++send_cycles_;
    if (sending_ == Sending::first_frame) {
        send_first();
    } else if (sending_ == Sending::consecutive_frames) {
        send_consecutive();
    } else {
        // the tester's turn
    }
    if (send_cycles_ > time_out_cycles) {
        sending_ = Sending::nothing;
    }
}

// The next bytes of the response.
void IsoTp::fill(Payload& payload, std::size_t from, std::size_t count) const noexcept {
    for (std::size_t index = 0U; index < count; ++index) {
        payload[from + index] = response_->byte(sent_ + index);
    }
}

void IsoTp::send_first() noexcept {
    const std::size_t length = response_->length();
    const bool is_single = (length <= bytes_per_frame);
    const std::size_t carried = is_single ? length : first_bytes;
    Payload payload = padded;
    payload[0] = static_cast<std::uint8_t>(is_single ? length : ((first_frame << 4U) | (length >> 8U)));
    payload[1] = static_cast<std::uint8_t>(length & 0xFFU);
    fill(payload, is_single ? 1U : 2U, carried);
    if (send_frame(payload)) {
        sent_ = carried;
        next_sent_ = 1U;
        send_cycles_ = 0U;
        sending_ = is_single ? Sending::nothing : Sending::waiting_for_flow_control;
    }
}

void IsoTp::send_consecutive() noexcept {
    if (gap_ > 0U) {
        --gap_;
    }
    for (std::uint32_t count = 0U;
         (count < most_frames_per_cycle) && (gap_ == 0U) && (sending_ == Sending::consecutive_frames);
         ++count) {
        const std::size_t carried = (left_to_send() < bytes_per_frame) ? left_to_send() : bytes_per_frame;
        Payload payload = padded;
        payload[0] = static_cast<std::uint8_t>((consecutive_frame << 4U) | next_sent_);
        fill(payload, 1U, carried);
        if (!send_frame(payload)) {
            return;
        }
        count_sent(carried);
    }
}

void IsoTp::count_sent(std::size_t bytes) noexcept {
    sent_ += bytes;
    next_sent_ = low_half(static_cast<std::uint8_t>(next_sent_ + 1U));
    send_cycles_ = 0U;
    gap_ = separation_;
    if (block_is_limited_) {
        --block_left_;
    }
    if (left_to_send() == 0U) {
        sending_ = Sending::nothing;
    } else if (block_is_limited_ && (block_left_ == 0U)) {
        sending_ = Sending::waiting_for_flow_control;
    } else {
        // on with the block
    }
}

}  // namespace rsi::diagnosis
