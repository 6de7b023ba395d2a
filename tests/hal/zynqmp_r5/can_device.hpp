// A CAN controller as UG1087 describes its registers, with the faults that a test wants.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "hal/zynqmp_r5/can_frame_layout.hpp"
#include "hal/zynqmp_r5/can_registers.hpp"
#include "tests/hal/zynqmp_r5/register_fake.hpp"

namespace hal::zynqmp_r5::testing {

class CanDevice final : public Device {
 public:
    bool responds_to_reset{true};
    bool filters_stay_busy{false};
    bool has_bus{true};  // false: nobody acknowledges, so that frames stay in the FIFO
    std::uint32_t error_state{1U};
    std::uint32_t errors{0U};  // error status register
    std::vector<CanFrameWords> sent;

    // A frame arrives from the bus.
    void arrive(const CanFrameWords& words) {
        if (!is_enabled() || !passes(words[0])) {
            return;
        }
        if (received_.size() == can::fifo_depth) {
            events_ |= can::event_bits::receive_overflow;
            return;
        }
        received_.push_back(words);
    }
    void raise(std::uint32_t events) { events_ |= events; }
    // The bus comes back: what waits in the FIFO leaves.
    void connect() {
        has_bus = true;
        transmit();
    }
    std::size_t waiting_to_leave() const { return to_send_.size(); }
    std::uint32_t value_of(RegisterAddress address) const {
        const auto found = values_.find(address);
        return found == values_.end() ? 0U : found->second;
    }

    std::uint32_t on_read(RegisterAddress address) override {
        switch (address) {
            case can::status:
                return status();
            case can::error_status:
                return errors;
            case can::event_status:
                return events_ | standing_events();
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
        values_[address] = value;
        switch (address) {
            case can::software_reset:
                reset_or_enable(value);
                break;
            case can::event_clear:
                events_ &= ~value;
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

    std::uint32_t status() const {
        std::uint32_t bits = filters_stay_busy ? can::status_bits::filters_busy : 0U;
        if (!is_enabled()) {
            bits |= responds_to_reset ? can::status_bits::configuration : 0U;
        } else {
            bits |= (1U << 3U) | (error_state << 7U);
        }
        if (to_send_.size() == can::fifo_depth) {
            bits |= can::status_bits::transmit_fifo_full;
        }
        return bits;
    }

    // Cleared events that still hold come back.
    std::uint32_t standing_events() const {
        return (received_.empty() ? 0U : can::event_bits::receive_fifo_not_empty) |
               (to_send_.empty() ? can::event_bits::transmit_fifo_empty : 0U);
    }

    void reset_or_enable(std::uint32_t value) {
        if ((value & can::reset_bits::reset) != 0U) {
            received_.clear();
            to_send_.clear();
            events_ = 0U;
            values_ = {{can::software_reset, value}};
        } else if ((value & can::reset_bits::enable) != 0U) {
            transmit();
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
        transmit();
    }

    void transmit() {
        if (has_bus && is_enabled()) {
            sent.insert(sent.end(), to_send_.begin(), to_send_.end());
            to_send_.clear();
        }
    }

    std::map<RegisterAddress, std::uint32_t> values_;
    std::uint32_t events_{0U};
    std::deque<CanFrameWords> received_;
    std::deque<CanFrameWords> to_send_;
    CanFrameWords current_{};
};

}  // namespace hal::zynqmp_r5::testing
