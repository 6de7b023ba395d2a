// CAN controller of the Zynq UltraScale+ MPSoC (CAN0), polled.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/interface/can_bus.hpp"
#include "hal/interface/clock.hpp"
#include "hal/interface/saturating_count.hpp"
#include "hal/interface/well_formed.hpp"
#include "hal/zynqmp_r5/registers.hpp"

namespace hal::zynqmp_r5 {

namespace can {
inline constexpr RegisterAddress base{0xFF06'0000U};
inline constexpr RegisterAddress software_reset{base + 0x00U};
inline constexpr RegisterAddress baud_rate_prescaler{base + 0x08U};
inline constexpr RegisterAddress bit_timing{base + 0x0CU};
inline constexpr RegisterAddress status{base + 0x18U};
inline constexpr RegisterAddress interrupt_status{base + 0x1CU};
inline constexpr RegisterAddress interrupt_clear{base + 0x24U};
inline constexpr RegisterAddress transmit_fifo{base + 0x30U};
inline constexpr RegisterAddress receive_fifo{base + 0x50U};
inline constexpr RegisterAddress filter_enable{base + 0x60U};
inline constexpr RegisterAddress filters{base + 0x64U};
}  // namespace can

template <typename Registers, typename Policy>
class CanController final : public CanBus {
 public:
    CanController(Registers registers, const Clock& clock) noexcept : registers_{registers}, clock_{clock} {}

    void open() noexcept {
        registers_.write(can::software_reset, 1U);
        registers_.write(can::baud_rate_prescaler, 9U);
        registers_.write(can::bit_timing, 0x12FU);
        registers_.write(can::filter_enable, 0U);
        registers_.write(can::software_reset, 2U);
    }

    ReceiveResult receive(CanFrame& frame) noexcept override {
        if ((registers_.read(can::interrupt_status) & (1U << 7U)) == 0U) {
            return ReceiveResult::empty;
        }
        CanFrame got{};
        got.identifier = (registers_.read(can::receive_fifo) >> Policy::identifier_shift) & 0x7FFU;
        const std::uint32_t length = registers_.read(can::receive_fifo + 4U) >> 28U;
        const std::array<std::uint32_t, 2> words{registers_.read(can::receive_fifo + 8U),
                                                 registers_.read(can::receive_fifo + 12U)};
        registers_.write(can::interrupt_clear, 1U << 7U);
        got.length = static_cast<std::uint8_t>(length > 8U ? 8U : length);
        for (std::size_t i = 0U; i < 8U; ++i) {
            got.data[i] = static_cast<std::uint8_t>(words[i / 4U] >> shift_of(i));
        }
        got.receive_time = clock_.now();
        count_up(statistics_.frames_received);
        frame = got;
        return ReceiveResult::frame;
    }

    SendResult send(const CanFrame& frame) noexcept override {
        if ((registers_.read(can::status) & (1U << 10U)) != 0U) {
            count_up(statistics_.send_failures);
            return SendResult::full;
        }
        std::array<std::uint32_t, 2> words{};
        for (std::size_t i = 0U; i < 8U; ++i) {
            words[i / 4U] |= static_cast<std::uint32_t>(frame.data[i]) << shift_of(i);
        }
        registers_.write(can::transmit_fifo, frame.identifier << Policy::identifier_shift);
        registers_.write(can::transmit_fifo + 4U, static_cast<std::uint32_t>(frame.length) << 28U);
        registers_.write(can::transmit_fifo + 8U, words[0]);
        registers_.write(can::transmit_fifo + 12U, words[1]);
        count_up(statistics_.frames_sent);
        return SendResult::sent;
    }

    BusState state() const noexcept override { return BusState::error_active; }
    BusStatistics statistics() const noexcept override { return statistics_; }

 private:
    static constexpr std::uint32_t shift_of(std::size_t byte) {
        const auto place = static_cast<std::uint32_t>(byte % 4U);
        return 8U * (Policy::first_byte_is_most_significant ? 3U - place : place);
    }

    Registers registers_;
    const Clock& clock_;
    BusStatistics statistics_{};
};

}  // namespace hal::zynqmp_r5
