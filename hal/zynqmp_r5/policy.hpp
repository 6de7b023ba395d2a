// What differs between the silicon and its emulator (QEMU 7.2, machine xlnx-zcu102), in one type each. Chosen
// at build time (RSI_ZYNQMP_POLICY_SILICON or RSI_ZYNQMP_POLICY_EMULATOR); everything else of the image is
// the same.
#pragma once

#include <cstdint>

namespace hal::zynqmp_r5 {

// As the Zynq UltraScale+ Device Technical Reference Manual (UG1085) and register reference (UG1087) have it.
struct SiliconPolicy {
    static constexpr std::uint32_t timer_clock_hz{100'000'000U};
    static constexpr std::uint32_t identifier_shift{21U};
    static constexpr bool first_byte_is_most_significant{true};
};

// QEMU keeps the identifier where SocketCAN has it and the first byte in the lowest bits.
struct EmulatorPolicy {
    static constexpr std::uint32_t timer_clock_hz{133'000'000U};
    static constexpr std::uint32_t identifier_shift{0U};
    static constexpr bool first_byte_is_most_significant{false};
};

#if defined(RSI_ZYNQMP_POLICY_EMULATOR)
using Policy = EmulatorPolicy;
#elif defined(RSI_ZYNQMP_POLICY_SILICON)
using Policy = SiliconPolicy;
#endif

}  // namespace hal::zynqmp_r5
