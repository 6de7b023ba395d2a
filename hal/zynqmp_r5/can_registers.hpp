// Registers of the CAN controller (Zynq UltraScale+ Device TRM, UG1085, and register reference, UG1087).
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/zynqmp_r5/registers.hpp"

namespace rsi::hal::zynqmp_r5::can {

inline constexpr RegisterAddress base{0xFF06'0000U};  // CAN0

inline constexpr RegisterAddress software_reset{base + 0x00U};
inline constexpr RegisterAddress mode_select{base + 0x04U};
inline constexpr RegisterAddress bit_rate_prescaler{base + 0x08U};
inline constexpr RegisterAddress bit_timing{base + 0x0CU};
inline constexpr RegisterAddress error_status{base + 0x14U};  // a bit is cleared by writing 1
inline constexpr RegisterAddress status{base + 0x18U};
inline constexpr RegisterAddress event_status{base +
                                              0x1CU};  // "ISR"; polled here, so no interrupt is enabled
inline constexpr RegisterAddress event_enable{base + 0x20U};   // "IER"
inline constexpr RegisterAddress event_clear{base + 0x24U};    // "ICR"
inline constexpr RegisterAddress transmit_fifo{base + 0x30U};  // identifier, length, two words of data
inline constexpr RegisterAddress receive_fifo{base + 0x50U};   // the same
inline constexpr RegisterAddress filter_enable{base + 0x60U};
inline constexpr RegisterAddress filter_mask{base +
                                             0x64U};  // of the first filter; the others 8 bytes on each
inline constexpr RegisterAddress filter_identifier{base + 0x68U};  // likewise
inline constexpr RegisterAddress filter_stride{8U};
inline constexpr std::size_t filter_count{4U};
inline constexpr std::size_t fifo_depth{64U};  // frames, in each direction

namespace reset_bits {
inline constexpr std::uint32_t reset{1U << 0U};
inline constexpr std::uint32_t enable{1U << 1U};
}  // namespace reset_bits

namespace status_bits {
inline constexpr std::uint32_t configuration{1U << 0U};
inline constexpr std::uint32_t error_state{3U << 7U};
inline constexpr std::uint32_t bus_off{2U << 7U};
inline constexpr std::uint32_t error_passive{3U << 7U};
inline constexpr std::uint32_t transmit_fifo_full{1U << 10U};
inline constexpr std::uint32_t filters_busy{1U << 11U};
}  // namespace status_bits

// An event stays set until it is cleared. The manual leaves open whether one that stands (a FIFO that is
// empty, or holds frames) is set again as soon as it is cleared, or only when it begins anew.
namespace event_bits {
inline constexpr std::uint32_t transmit_ok{1U << 1U};  // one frame has left and was acknowledged
inline constexpr std::uint32_t receive_overflow{1U << 6U};
inline constexpr std::uint32_t receive_fifo_not_empty{1U << 7U};
inline constexpr std::uint32_t error{1U << 8U};
inline constexpr std::uint32_t bus_off{1U << 9U};
inline constexpr std::uint32_t transmit_fifo_empty{1U << 14U};
inline constexpr std::uint32_t all{0x7FFFU};
}  // namespace event_bits

}  // namespace rsi::hal::zynqmp_r5::can
