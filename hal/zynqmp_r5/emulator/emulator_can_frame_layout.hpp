// How a CAN frame lies in the FIFO of QEMU's controller: four words, as on silicon, but filled otherwise.
#pragma once

#include "hal/zynqmp_r5/can_frame_layout.hpp"

namespace rsi::hal::zynqmp_r5 {

// QEMU 7.2 passes on the words of Linux' can_frame: identifier in the lowest bits, extension in bit 31,
// remote request in 30, error in 29; the first byte of data in the lowest bits.
struct EmulatorCanFrameLayout {
    static constexpr CanFrameWords pack(const CanFrame& frame) {
        return detail::pack(frame.identifier | (frame.extended ? extension : 0U), frame, false);
    }
    static constexpr bool unpack(const CanFrameWords& words, CanFrame& frame) {
        const std::uint32_t word = words[0];
        frame.extended = (word & extension) != 0U;
        frame.identifier = word & (frame.extended ? 0x1FFF'FFFFU : 0x7FFU);
        detail::unpack(words, frame, false);
        return (word & (remote_request | error)) == 0U;
    }
    static constexpr CanFilter filter(const CanAcceptance& accepted) {
        return CanFilter{accepted.mask | extension | remote_request | error, accepted.identifier};
    }

 private:
    static constexpr std::uint32_t extension{1U << 31U};
    static constexpr std::uint32_t remote_request{1U << 30U};
    static constexpr std::uint32_t error{1U << 29U};
};

}  // namespace rsi::hal::zynqmp_r5
