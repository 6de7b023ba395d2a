// A CAN controller as UG1087 describes its registers, with the faults that a test wants. Time passes in it: a
// register access takes a tenth of a microsecond, a frame its time on the bus.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "hal/zynqmp_r5/can_frame_layout.hpp"
#include "hal/zynqmp_r5/can_registers.hpp"
#include "tests/hal/zynqmp_r5/register_fake.hpp"

namespace rsi::hal::zynqmp_r5::testing {

// Meaning of the event "transmit FIFO empty". The manual can be read in all these ways.
enum class EmptyEvent {
    standing,          // set for as long as the FIFO is empty, and stays set until it is cleared
    level,             // the same, but gone as soon as the FIFO is not empty
    on_emptying,       // set once, when the last frame has left
    on_start_of_last,  // set once, when the last frame is out of the FIFO, but only begins to be sent
};

class CanDevice final : public Device {
 public:
    static constexpr std::int64_t access_ns{100};
    static constexpr std::int64_t eleven_bits_ns{22'000};  // at 500 kbit/s

    bool responds_to_reset{true};
    bool filters_stay_busy{false};
    bool has_bus{true};           // false: no node acknowledges, so that frames are tried for ever
    unsigned bus_dies_after{0U};  // so many frames more are acknowledged; 0: all
    EmptyEvent empty_event{EmptyEvent::standing};
    std::int64_t frame_ns{222'000};  // eight bytes at 500 kbit/s
    std::uint32_t error_state{1U};
    std::uint32_t errors{0U};  // error status register
    std::vector<CanFrameWords> sent;

    // A frame arrives from the bus.
    void arrive(const CanFrameWords& words) {
        if (!is_on_bus() || !passes(words[0])) {
            return;
        }
        if (received_.size() == can::fifo_depth) {
            events_ |= can::event_bits::receive_overflow;
            return;
        }
        received_.push_back(words);
        latch_standing_events();
    }
    void raise(std::uint32_t events) { events_ |= events; }
    // Too many errors: from now on nothing goes out or comes in, until the controller is reset.
    void go_bus_off() {
        error_state = 2U;
        events_ |= can::event_bits::bus_off;
        stop_sending();
    }
    // The bus comes back: what waits in the FIFO begins to leave.
    void connect() {
        has_bus = true;
        stop_sending();
        pass(0);
    }
    void pass(std::int64_t nanoseconds) {
        const std::int64_t end = now_ns_ + nanoseconds;
        for (;;) {
            begin_to_send();
            if (!sent_at_ || end < *sent_at_) {
                break;
            }
            now_ns_ = *sent_at_;
            finish_sending();
        }
        now_ns_ = end;
        latch_standing_events();
    }
    std::size_t waiting_to_leave() const { return to_send_.size(); }
    std::uint32_t value_of(RegisterAddress address) const {
        const auto found = values_.find(address);
        return found == values_.end() ? 0U : found->second;
    }

    std::uint32_t on_read(RegisterAddress address) override {
        pass(access_ns);
        switch (address) {
            case can::status:
                return status();
            case can::error_status:
                return errors;
            case can::event_status:
                return events_;
            case can::receive_fifo:
                return take_word(0U);
            case can::receive_fifo + 4U:
            case can::receive_fifo + 8U:
            case can::receive_fifo + 12U:
                return current_[(address - can::receive_fifo) / 4U];
            default:
                return value_of(address);
        }
    }

    void on_write(RegisterAddress address, std::uint32_t value) override {
        pass(access_ns);
        values_[address] = value;
        switch (address) {
            case can::software_reset:
                reset_or_enable(value);
                break;
            case can::event_clear:
                events_ &= ~value;
                latch_standing_events();
                break;
            case can::error_status:
                errors &= ~value;
                break;
            case can::transmit_fifo + 12U:
                accept();
                break;
            default:
                break;
        }
    }

 private:
    bool is_enabled() const { return (value_of(can::software_reset) & can::reset_bits::enable) != 0U; }
    // It joins the bus after eleven recessive bits.
    bool is_on_bus() const { return is_enabled() && on_bus_at_ <= now_ns_ && error_state != 2U; }

    std::uint32_t status() const {
        std::uint32_t bits = filters_stay_busy ? can::status_bits::filters_busy : 0U;
        if (!is_enabled() || now_ns_ < on_bus_at_) {
            bits |= responds_to_reset ? can::status_bits::configuration : 0U;
        } else {
            bits |= (1U << 3U) | (error_state << 7U);
        }
        if (to_send_.size() == can::fifo_depth) {
            bits |= can::status_bits::transmit_fifo_full;
        }
        return bits;
    }

    // Events that stand are set whenever they hold; clearing them is in vain then.
    void latch_standing_events() {
        constexpr std::uint32_t empty = can::event_bits::transmit_fifo_empty;
        events_ |= received_.empty() ? 0U : can::event_bits::receive_fifo_not_empty;
        if (empty_event == EmptyEvent::level) {
            events_ &= ~empty;
        }
        if (empty_event == EmptyEvent::level || empty_event == EmptyEvent::standing) {
            events_ |= to_send_.empty() ? empty : 0U;
        }
    }

    void reset_or_enable(std::uint32_t value) {
        stop_sending();
        if ((value & can::reset_bits::reset) != 0U) {
            received_.clear();
            to_send_.clear();
            events_ = 0U;
            error_state = 1U;
            values_ = {{can::software_reset, value}};
        } else if ((value & can::reset_bits::enable) != 0U) {
            on_bus_at_ = now_ns_ + eleven_bits_ns;
        }
    }

    bool passes(std::uint32_t identifier) const {
        const std::uint32_t enabled = value_of(can::filter_enable);
        bool passes = enabled == 0U;
        for (std::uint32_t i = 0U; i < can::filter_count; ++i) {
            const std::uint32_t mask = value_of(can::filter_mask + can::filter_stride * i);
            const std::uint32_t wanted = value_of(can::filter_identifier + can::filter_stride * i);
            passes = passes || ((enabled & (1U << i)) != 0U && (identifier & mask) == (wanted & mask));
        }
        return passes;
    }

    std::uint32_t take_word(std::size_t word) {
        if (received_.empty()) {
            current_ = {};
        } else {
            current_ = received_.front();
            received_.pop_front();
        }
        return current_[word];
    }

    void accept() {
        CanFrameWords words{};
        for (std::uint32_t word = 0U; word < words.size(); ++word) {
            words[word] = value_of(can::transmit_fifo + 4U * word);
        }
        if (is_enabled() && to_send_.size() < can::fifo_depth) {
            to_send_.push_back(words);
        }
        pass(0);
    }

    void begin_to_send() {
        if (is_sending_ || to_send_.empty() || !is_on_bus()) {
            return;
        }
        is_sending_ = true;
        if (has_bus) {
            sent_at_ = now_ns_ + frame_ns;
        }
        if (empty_event == EmptyEvent::on_start_of_last && to_send_.size() == 1U) {
            events_ |= can::event_bits::transmit_fifo_empty;
        }
    }

    void finish_sending() {
        stop_sending();
        sent.push_back(to_send_.front());
        to_send_.pop_front();
        events_ |= can::event_bits::transmit_ok;
        if (bus_dies_after != 0U && --bus_dies_after == 0U) {
            has_bus = false;
        }
        if (empty_event == EmptyEvent::on_emptying && to_send_.empty()) {
            events_ |= can::event_bits::transmit_fifo_empty;
        }
    }

    void stop_sending() {
        is_sending_ = false;
        sent_at_.reset();
    }

    std::int64_t now_ns_{0};
    std::int64_t on_bus_at_{0};
    bool is_sending_{false};
    std::optional<std::int64_t> sent_at_;  // of the frame that is being sent and acknowledged
    std::map<RegisterAddress, std::uint32_t> values_;
    std::uint32_t events_{0U};
    std::deque<CanFrameWords> received_;
    std::deque<CanFrameWords> to_send_;
    CanFrameWords current_{};
};

}  // namespace rsi::hal::zynqmp_r5::testing
