// CAN controller of the Zynq UltraScale+ MPSoC, classic frames, polled. No call waits for longer than
// about twice most_can_polls register accesses.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/memory/frame_ring.hpp"
#include "hal/zynqmp_r5/can_bit_timing.hpp"
#include "hal/zynqmp_r5/can_frame_layout.hpp"
#include "hal/zynqmp_r5/can_registers.hpp"
#include "hal/zynqmp_r5/registers.hpp"
#include "rsi/hal/bus_off_schedule.hpp"
#include "rsi/hal/can_bus.hpp"
#include "rsi/hal/clock.hpp"
#include "rsi/hal/saturating_count.hpp"
#include "rsi/hal/well_formed.hpp"

namespace rsi::hal::zynqmp_r5 {

struct CanSettings {
    CanBitTiming timing{can_bit_timing<100'000'000U, 500'000U>()};
    // Only data frames that one of these accepts are let through, by the controller; none given means all.
    std::array<CanAcceptance, can::filter_count> accepted{};
    std::size_t accepted_count{0U};  // 0 to 4
};

// Accesses to a register for which the controller is given to follow a request.
inline constexpr std::uint32_t most_can_polls{1000U};

// A controller that does not respond does not disturb the bus, so longer waits would not help: it is tried
// again at an even pace. A try costs at most two waits of most_can_polls, some 0.2 ms.
inline constexpr Time interval_of_tries = Time::from_milliseconds(100);

// Frames that take_waiting() keeps: more than a cycle has on a bus that is not flooded. The FIFO keeps the
// rest.
inline constexpr std::size_t most_taken{32U};

// Frames still in the FIFO after this time are discarded: a warning of yesterday must not go out when the
// bus comes back.
inline constexpr Time oldest_unsent_frame = Time::from_milliseconds(50);

// `Registers` reads and writes registers, `Layout` says how a frame lies in the FIFO.
// Call receive() in every cycle; it also follows the state of the bus: overflow, errors, bus-off and the way
// back, frames that do not leave. frames_lost counts the events of overflow; the controller does not tell how
// many frames each of them cost.
//
// All identifiers share one receive FIFO, first in, first out, and the controller notes no time of arrival:
// receive_time is when receive() or take_waiting() took the frame from it. Call take_waiting() in the time
// between two cycles. Without it a frame has waited for up to one cycle, and for longer after a
// cycle that came late, but never for longer than the watchdog's limit (the reset empties the FIFO) or than
// 64 frames take to arrive (the FIFO drops what comes when it is full, so what is old stays and what is new
// is lost). Take all that waits in each cycle, so that the last frame of an identifier is the newest.
template <typename Registers, typename Layout>
class CanController final : public CanBus {
 public:
    // `clock` must outlive the controller.
    CanController(Registers registers, const Clock& clock) noexcept : registers_{registers}, clock_{clock} {}

    // Starts the controller; the statistics start at zero. False when it does not respond or the settings are
    // not possible; the former is tried again from receive().
    bool open(const CanSettings& settings = {}) noexcept {
        settings_ = settings;
        statistics_ = BusStatistics{};
        bus_off_schedule_.reset();
        opened_ = are_possible(settings);
        if (!opened_) {
            return false;
        }
        restart();
        return standing_ == Standing::on;
    }

    // Takes the frames that wait in the controller, for receive() to give out with the time of this call.
    void take_waiting() noexcept {
        CanFrame frame{};
        while (taken_.size() < most_taken && take(frame) == ReceiveResult::frame) {
            static_cast<void>(taken_.push(frame));
        }
    }

    ReceiveResult receive(CanFrame& frame) noexcept override {
        return taken_.pop(frame) ? ReceiveResult::frame : take(frame);
    }

    // A CAN FD frame is not possible on this controller.
    SendResult send(const CanFrame& frame) noexcept override {
        const std::uint32_t status = registers_.read(can::status);
        if (standing_ != Standing::on || (status & can::status_bits::configuration) != 0U ||
            frame.flexible_data_rate || !is_well_formed(frame)) {
            return send_failed(SendResult::failed);
        }
        if ((status & can::status_bits::transmit_fifo_full) != 0U) {
            return send_failed(SendResult::full);
        }
        if (pending_ != 0U) {
            follow_transmission(registers_.read(can::event_status));
        }
        if (pending_ == 0U) {
            pending_since_ = clock_.now();
            registers_.write(can::event_clear, can::event_bits::transmit_ok);
        }
        count_up(pending_);
        write_frame(registers_, frame);
        forget_empty_fifo(registers_);
        count_up(statistics_.frames_sent);
        return SendResult::sent;
    }

    BusState state() const noexcept override {
        if (standing_ != Standing::on) {
            return standing_ == Standing::bus_off ? BusState::bus_off : BusState::closed;
        }
        const std::uint32_t status = registers_.read(can::status);
        if ((status & can::status_bits::configuration) != 0U) {
            return BusState::closed;  // on its way to the bus: it waits for 11 recessive bits
        }
        switch (status & can::status_bits::error_state) {
            case can::status_bits::bus_off:
                return BusState::bus_off;
            case can::status_bits::error_passive:
                return BusState::error_passive;
            default:  // error active; QEMU leaves the field at zero
                return BusState::error_active;
        }
    }

    BusStatistics statistics() const noexcept override { return statistics_; }

    // For the way to a reset, on whatever state the controller is in: sends one frame and waits until all has
    // left, for `most_polls` register accesses at most. True when it has. Needs no object: that may be
    // damaged.
    static bool send_last(Registers registers, const CanFrame& frame, std::uint32_t most_polls) noexcept {
        const auto is_set = [&registers](RegisterAddress address, std::uint32_t bits) {
            return (registers.read(address) & bits) != 0U;
        };
        if (is_set(can::status, can::status_bits::configuration)) {
            return false;
        }
        std::uint32_t polls = 0U;
        while (is_set(can::status, can::status_bits::transmit_fifo_full)) {
            if (++polls >= most_polls) {
                return false;
            }
        }
        registers.write(can::event_clear, can::event_bits::transmit_ok);
        write_frame(registers, frame);
        forget_empty_fifo(registers);
        while (!have_all_left(registers.read(can::event_status))) {
            if (++polls >= most_polls) {
                return false;
            }
        }
        return true;
    }

 private:
    enum class Standing : std::uint8_t { closed, on, bus_off };

    static constexpr bool are_possible(const CanSettings& settings) {
        bool possible = settings.accepted_count <= settings.accepted.size();
        for (std::size_t i = 0U; possible && i < settings.accepted_count; ++i) {
            possible = is_identifier_possible(settings.accepted[i].identifier, false) &&
                       is_identifier_possible(settings.accepted[i].mask, false);
        }
        return possible;
    }

    // The oldest frame in the FIFO.
    ReceiveResult take(CanFrame& frame) noexcept {
        if (!follow()) {
            return ReceiveResult::failed;
        }
        for (std::size_t skipped = 0U; skipped < can::fifo_depth; ++skipped) {
            if ((take_events() & can::event_bits::receive_fifo_not_empty) == 0U) {
                return ReceiveResult::empty;
            }
            CanFrame received{};
            if (read_frame(received)) {
                received.receive_time = clock_.now();
                frame = received;
                count_up(statistics_.frames_received);
                bus_off_schedule_.reset();
                return ReceiveResult::frame;
            }
        }
        return ReceiveResult::empty;
    }

    static void write_frame(Registers registers, const CanFrame& frame) noexcept {
        const CanFrameWords words = Layout::pack(frame);
        for (std::uint32_t word = 0U; word < words.size(); ++word) {
            registers.write(can::transmit_fifo + 4U * word, words[word]);  // the last one sends
        }
    }

    // The event "transmit FIFO empty" is cleared behind the frame, not before it: in front of it the FIFO may
    // still be empty, or become so, and the event would say "left" of a frame that has not. Nor is the new
    // event lost: between these two writes lie a tenth of a microsecond and no interrupt, and a frame needs
    // at least 47 bit times. (Under the emulator it needs none, but there the event stands, and comes back
    // when it is cleared.)
    static void forget_empty_fifo(Registers registers) noexcept {
        registers.write(can::event_clear, can::event_bits::transmit_fifo_empty);
    }

    // An empty FIFO alone might mean that its last frame is still being tried, and "transmit OK", which is
    // cleared in front of the first frame, that only the first has left.
    static constexpr bool have_all_left(std::uint32_t events) noexcept {
        constexpr std::uint32_t both = can::event_bits::transmit_ok | can::event_bits::transmit_fifo_empty;
        return (events & both) == both;
    }

    // For a single frame "transmit OK" is enough, whatever the other event means.
    void follow_transmission(std::uint32_t events) noexcept {
        const bool one_left = pending_ == 1U && (events & can::event_bits::transmit_ok) != 0U;
        if (one_left || have_all_left(events)) {
            pending_ = 0U;
        }
    }

    bool read_frame(CanFrame& frame) noexcept {
        CanFrameWords words{};
        for (std::uint32_t word = 0U; word < words.size(); ++word) {
            words[word] = registers_.read(can::receive_fifo + 4U * word);
        }
        registers_.write(can::event_clear,
                         can::event_bits::receive_fifo_not_empty);  // comes back while frames wait
        return Layout::unpack(words, frame);
    }

    bool wait_for(std::uint32_t bits, std::uint32_t value) noexcept {
        for (std::uint32_t polls = 0U; polls < most_can_polls; ++polls) {
            if ((registers_.read(can::status) & bits) == value) {
                return true;
            }
        }
        return false;
    }

    // Resets the controller, which empties its FIFOs, and puts it on the bus anew.
    void restart() noexcept {
        pending_ = 0U;
        registers_.write(can::software_reset, can::reset_bits::reset);
        if (!wait_for(can::status_bits::configuration, can::status_bits::configuration)) {
            return stay_off(Standing::closed, interval_of_tries);
        }
        registers_.write(can::mode_select, 0U);  // normal: neither loop-back nor sleep nor snoop
        registers_.write(can::bit_rate_prescaler, settings_.timing.prescaler_register);
        registers_.write(can::bit_timing, settings_.timing.timing_register);
        if (!set_filters()) {
            return stay_off(Standing::closed, interval_of_tries);
        }
        registers_.write(can::event_enable, 0U);
        registers_.write(can::event_clear, can::event_bits::all);
        registers_.write(can::software_reset, can::reset_bits::enable);
        standing_ = Standing::on;
    }

    bool set_filters() noexcept {
        registers_.write(can::filter_enable, 0U);
        if (!wait_for(can::status_bits::filters_busy, 0U)) {
            return false;
        }
        for (std::size_t i = 0U; i < settings_.accepted_count; ++i) {
            const CanFilter filter = Layout::filter(settings_.accepted[i]);
            const auto offset = static_cast<RegisterAddress>(i) * can::filter_stride;
            registers_.write(can::filter_mask + offset, filter.mask);
            registers_.write(can::filter_identifier + offset, filter.identifier);
        }
        registers_.write(can::filter_enable, (1U << settings_.accepted_count) - 1U);
        return true;
    }

    // True when the controller is on the bus, or comes back to it now.
    bool follow() noexcept {
        if (!opened_) {
            return false;
        }
        const Time now = clock_.now();
        if (standing_ == Standing::on) {
            static_cast<void>(take_events());
        }
        if (standing_ == Standing::on) {
            if (pending_ != 0U && oldest_unsent_frame < now - pending_since_) {
                count_up(statistics_.send_failures);
                restart();
            }
        } else if (!(now < on_again_)) {
            restart();
        } else {
            // Still waiting to come back.
        }
        return standing_ == Standing::on;
    }

    // Reads the events and acts upon them.
    std::uint32_t take_events() noexcept {
        const std::uint32_t events = registers_.read(can::event_status);
        const std::uint32_t acted_upon =
            events & (can::event_bits::receive_overflow | can::event_bits::error | can::event_bits::bus_off);
        if (acted_upon != 0U) {
            registers_.write(can::event_clear, acted_upon);
        }
        if ((events & can::event_bits::receive_overflow) != 0U) {
            count_up(statistics_.frames_lost);
        }
        if ((events & can::event_bits::error) != 0U) {
            count_up(statistics_.error_frames);
            registers_.write(can::error_status, registers_.read(can::error_status));
        }
        follow_transmission(events);
        if ((events & can::event_bits::bus_off) != 0U) {
            registers_.write(can::software_reset, 0U);  // off the bus, until it is restarted
            stay_off(Standing::bus_off, bus_off_schedule_.next());
        }
        return events;
    }

    void stay_off(Standing why, Time interval) noexcept {
        standing_ = why;
        pending_ = 0U;
        on_again_ = clock_.now() + interval;
    }

    SendResult send_failed(SendResult result) noexcept {
        count_up(statistics_.send_failures);
        return result;
    }

    Registers registers_;
    const Clock& clock_;
    CanSettings settings_{};
    BusStatistics statistics_{};
    Standing standing_{Standing::closed};
    bool opened_{false};
    std::uint32_t pending_{
        0U};  // frames of which the last may still be in the controller's FIFO; the first since:
    Time pending_since_{};
    Time on_again_{};
    BusOffSchedule bus_off_schedule_;
    FrameRing<most_taken> taken_{};
};

}  // namespace rsi::hal::zynqmp_r5
