// System reset: the whole device, as after power-on but for what the reset leaves in memory.
#pragma once

#include <cstdint>

#include "hal/zynqmp_r5/registers.hpp"

namespace rsi::hal::zynqmp_r5 {

namespace reset_controller {
inline constexpr RegisterAddress control{0xFF5E'0218U};  // CRL_APB.RESET_CTRL (UG1087)
inline constexpr std::uint32_t soft_reset{1U << 4U};
}  // namespace reset_controller

template <typename Registers>
struct SystemReset {
    // Asks for it; it comes within microseconds.
    static void request(Registers registers) noexcept {
        registers.write(reset_controller::control,
                        registers.read(reset_controller::control) | reset_controller::soft_reset);
    }
};

}  // namespace rsi::hal::zynqmp_r5
