// Regions of the memory protection unit (Arm Cortex-R5 TRM, DDI 0460, chapter "Memory Protection Unit").
#pragma once

#include <array>
#include <cstdint>

#include "hal/zynqmp_r5/can_registers.hpp"
#include "hal/zynqmp_r5/memory_map.h"
#include "hal/zynqmp_r5/system_reset.hpp"
#include "hal/zynqmp_r5/system_watchdog.hpp"
#include "hal/zynqmp_r5/timer_clock.hpp"

namespace rsi::hal::zynqmp_r5 {

// Rights in a region; a higher region wins where two overlap. Without a region every access aborts.
enum class Access : std::uint32_t {  // region access control register
    // Normal memory, write-back, write-allocate, not shared: TEX 1, C, B.
    execute = (5U << 8U) | (1U << 3U) | (1U << 1U) | 1U,                  // privileged read only
    constants = (1U << 12U) | (5U << 8U) | (1U << 3U) | (1U << 1U) | 1U,  // the same, never executed
    data = (1U << 12U) | (1U << 8U) | (1U << 3U) | (1U << 1U) | 1U,       // privileged read and write
    uncached = (1U << 12U) | (1U << 8U) | (1U << 3U),                     // TEX 1 alone
    device = (1U << 12U) | (1U << 8U) | 1U,                               // shared device: B alone
};

struct Region {
    std::uint32_t start{0U};
    std::uint32_t size{0U};  // bytes, a power of two from 32 on
    Access access{Access::constants};
    std::uint32_t left_out{0U};  // bit n: the region does not hold its nth eighth
};

constexpr bool is_possible(const Region& region) {
    const bool power_of_two = region.size >= 32U && (region.size & (region.size - 1U)) == 0U;
    const bool eighths = region.left_out == 0U || (region.size >= 256U && region.left_out <= 0xFFU);
    return power_of_two && (region.start & (region.size - 1U)) == 0U && eighths;
}

// Region size and enable register: exponent of the size less one in bits 5 to 1.
constexpr std::uint32_t size_and_enable(const Region& region) {
    std::uint32_t exponent = 0U;
    while (exponent < 31U && (std::uint32_t{1U} << exponent) < region.size) {
        ++exponent;
    }
    return (region.left_out << 8U) | ((exponent - 1U) << 1U) | 1U;
}

// The guards of the stacks are left out of their region, so that no region holds them.
inline constexpr std::uint32_t stack_part{RSI_STACKS_SIZE / 8U};
inline constexpr std::uint32_t stack_guards{0b1110'0101U};
inline constexpr std::uint32_t peripheral_size{0x1000U};

inline constexpr std::array<Region, 10> regions{{
    {RSI_VECTORS_START, RSI_VECTORS_SIZE, Access::execute},
    {RSI_CODE_START, RSI_CODE_SIZE, Access::execute},
    {RSI_PARAMETERS_START, RSI_PARAMETERS_SIZE, Access::constants},
    {RSI_DATA_START, RSI_DATA_SIZE, Access::data},
    {RSI_STACKS_START, RSI_STACKS_SIZE, Access::data, stack_guards},
    {RSI_RETAINED_START, RSI_RETAINED_SIZE, Access::uncached},
    {can::base, peripheral_size, Access::device},
    {timer::base, peripheral_size, Access::device},
    {watchdog::base, peripheral_size, Access::device},
    {reset_controller::control & ~(peripheral_size - 1U), peripheral_size, Access::device},
}};

static_assert(RSI_FAULT_STACK_BOTTOM == RSI_STACKS_START + 1U * stack_part &&
                  RSI_FAULT_STACK_TOP == RSI_STACKS_START + 2U * stack_part &&
                  RSI_MAIN_STACK_BOTTOM == RSI_STACKS_START + 3U * stack_part &&
                  RSI_MAIN_STACK_TOP == RSI_STACKS_START + 5U * stack_part,
              "stack_guards does not leave out what lies between the stacks");

constexpr bool are_possible(const std::array<Region, 10>& all) {
    bool possible = true;
    for (const Region& region : all) {
        possible = possible && is_possible(region);
    }
    return possible;
}
static_assert(are_possible(regions), "a region's size or start is none that the unit knows");

}  // namespace rsi::hal::zynqmp_r5
