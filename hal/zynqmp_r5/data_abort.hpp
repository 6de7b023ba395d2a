// Description of a data abort, from the registers that describe it (Arm Cortex-R5 TRM, DDI 0460, data fault
// status and address register).
#pragma once

#include <cstdint>

#include "hal/zynqmp_r5/fault_record.hpp"
#include "hal/zynqmp_r5/memory_map.h"

namespace rsi::hal::zynqmp_r5 {

// Bits 10 and 3 to 0 of DFSR. The other kinds (an asynchronous external abort, 0x406, or parity error, 0x408,
// and debug events) come late, and leave in DFAR whatever was there.
enum class DataFault : std::uint32_t {
    background = 0x000,  // the memory protection unit: no region
    alignment = 0x001,
    external = 0x008,
    permission = 0x00D,  // the memory protection unit
    parity = 0x409,
};

constexpr DataFault data_fault_of(std::uint32_t status) {
    return static_cast<DataFault>(status & 0x40FU);
}

// Whether DFAR holds the address that the access wanted.
constexpr bool has_address(DataFault fault) {
    return fault == DataFault::background || fault == DataFault::alignment || fault == DataFault::external ||
           fault == DataFault::permission || fault == DataFault::parity;
}

constexpr bool is_in_stack_guard(std::uint32_t address) {
    const bool in_stacks = address >= RSI_STACKS_START && address < RSI_STACKS_START + RSI_STACKS_SIZE;
    const bool in_fault_stack = address >= RSI_FAULT_STACK_BOTTOM && address < RSI_FAULT_STACK_TOP;
    const bool in_main_stack = address >= RSI_MAIN_STACK_BOTTOM && address < RSI_MAIN_STACK_TOP;
    return in_stacks && !in_fault_stack && !in_main_stack;
}

// `status` is DFSR, `address` DFAR.
constexpr Fault describe_data_abort(std::uint32_t status, std::uint32_t address) {
    const bool address_is_known = has_address(data_fault_of(status));
    Fault fault{};
    fault.status = status;
    fault.data = address_is_known ? address : 0U;
    fault.reason = address_is_known && is_in_stack_guard(address) ? ResetReason::stack_overflow
                                                                  : ResetReason::data_abort;
    return fault;
}

}  // namespace rsi::hal::zynqmp_r5
