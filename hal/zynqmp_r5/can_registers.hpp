// Registers of the CAN controller, 32 bits each (Zynq UltraScale+ Device TRM, UG1085; register reference,
// UG1087, module CAN). A name in quotation marks is the manual's.
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/zynqmp_r5/registers.hpp"

namespace rsi::hal::zynqmp_r5::can {

inline constexpr RegisterAddress base{0xFF06'0000U};  // CAN0

inline constexpr RegisterAddress software_reset{base + 0x00U};      // "SRR"
inline constexpr RegisterAddress mode_select{base + 0x04U};         // "MSR"
inline constexpr RegisterAddress bit_rate_prescaler{base + 0x08U};  // "BRPR"
inline constexpr RegisterAddress bit_timing{base + 0x0CU};          // "BTR"
inline constexpr RegisterAddress error_status{base + 0x14U};        // "ESR"; write 1 to clear
inline constexpr RegisterAddress status{base + 0x18U};              // "SR"
// "ISR", "IER" and "ICR". This driver polls the interrupt status and enables no interrupt, hence "event".
inline constexpr RegisterAddress event_status{base + 0x1CU};
inline constexpr RegisterAddress event_enable{base + 0x20U};
inline constexpr RegisterAddress event_clear{base + 0x24U};
// Four words each: identifier, length, two words of data.
inline constexpr RegisterAddress transmit_fifo{base + 0x30U};  // "TXFIFO_ID"
inline constexpr RegisterAddress receive_fifo{base + 0x50U};   // "RXFIFO_ID"
// Acceptance filters. Mask and identifier of filter n are n * filter_stride bytes after those of filter 0.
inline constexpr RegisterAddress filter_enable{base + 0x60U};      // "AFR", one bit for each filter
inline constexpr RegisterAddress filter_mask{base + 0x64U};        // "AFMR1"
inline constexpr RegisterAddress filter_identifier{base + 0x68U};  // "AFIR1"
inline constexpr RegisterAddress filter_stride{8U};
inline constexpr std::size_t filter_count{4U};
inline constexpr std::size_t fifo_depth{64U};  // frames, in each direction

namespace reset_bits {
inline constexpr std::uint32_t reset{1U << 0U};   // "SRST"
inline constexpr std::uint32_t enable{1U << 1U};  // "CEN"
}  // namespace reset_bits

namespace status_bits {
inline constexpr std::uint32_t configuration{1U << 0U};  // "CONFIG": configuration mode, off the bus
// Mask of the field "ESTAT", and two of its values.
inline constexpr std::uint32_t error_state{3U << 7U};
inline constexpr std::uint32_t bus_off{2U << 7U};
inline constexpr std::uint32_t error_passive{3U << 7U};
inline constexpr std::uint32_t transmit_fifo_full{1U << 10U};  // "TXFLL"
inline constexpr std::uint32_t filters_busy{1U << 11U};        // "ACFBSY"
}  // namespace status_bits

// Each bit stays set until it is cleared. The manual does not say whether a bit whose cause persists (FIFO
// empty, FIFO not empty) is set again at once after a clear, or only at the next change.
namespace event_bits {
inline constexpr std::uint32_t transmit_ok{1U << 1U};             // "TXOK": a frame was sent and acknowledged
inline constexpr std::uint32_t receive_overflow{1U << 6U};        // "RXOFLW"
inline constexpr std::uint32_t receive_fifo_not_empty{1U << 7U};  // "RXNEMP"
inline constexpr std::uint32_t error{1U << 8U};                   // "ERROR"; its kind is in error_status
inline constexpr std::uint32_t bus_off{1U << 9U};                 // "BSOFF"
inline constexpr std::uint32_t transmit_fifo_empty{1U << 14U};    // "TXFEMP"
inline constexpr std::uint32_t all{0x7FFFU};
}  // namespace event_bits

}  // namespace rsi::hal::zynqmp_r5::can
