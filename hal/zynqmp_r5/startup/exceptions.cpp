// The reaction to every exception: record it, let the image say so on the bus, reset.
#include "hal/zynqmp_r5/startup/exceptions.hpp"

#include "hal/zynqmp_r5/memory_map.h"
#include "hal/zynqmp_r5/policy.hpp"
#include "hal/zynqmp_r5/registers.hpp"

namespace hal::zynqmp_r5 {
namespace {

// As start.S numbers them.
enum class Exception : std::uint32_t {
    undefined_instruction = 1,
    supervisor_call = 2,
    prefetch_abort = 3,
    data_abort = 4,
    reserved = 5,
    interrupt = 6,
    fast_interrupt = 7,
};

[[gnu::section(".retained")]] FaultRecord retained_record;

// Set from the first exception to the reset. The start clears it.
volatile bool is_handling = false;

bool is_in_stack_guard(std::uint32_t address) {
    const bool in_stacks = address >= RSI_STACKS_START && address < RSI_STACKS_START + RSI_STACKS_SIZE;
    const bool in_fault_stack = address >= RSI_FAULT_STACK_BOTTOM && address < RSI_FAULT_STACK_TOP;
    const bool in_main_stack = address >= RSI_MAIN_STACK_BOTTOM && address < RSI_MAIN_STACK_TOP;
    return in_stacks && !in_fault_stack && !in_main_stack;
}

Fault describe(Exception exception) {
    Fault fault{};
    switch (exception) {
        case Exception::undefined_instruction:
            fault.reason = ResetReason::undefined_instruction;
            break;
        case Exception::supervisor_call:
            fault.reason = ResetReason::supervisor_call;
            break;
        case Exception::prefetch_abort:
            fault.reason = ResetReason::prefetch_abort;
            asm volatile("mrc p15, 0, %0, c5, c0, 1" : "=r"(fault.status));  // IFSR
            break;
        case Exception::data_abort:
            asm volatile("mrc p15, 0, %0, c5, c0, 0" : "=r"(fault.status));  // DFSR
            asm volatile("mrc p15, 0, %0, c6, c0, 0" : "=r"(fault.data));    // DFAR
            fault.reason =
                is_in_stack_guard(fault.data) ? ResetReason::stack_overflow : ResetReason::data_abort;
            break;
        default:
            fault.reason = ResetReason::interrupt;
            break;
    }
    return fault;
}

}  // namespace

FaultRecord& fault_record() noexcept {
    return retained_record;
}

void reset_now() noexcept {
    asm volatile("dsb" : : : "memory");
    Policy::Reset<MemoryMappedRegisters>::request(MemoryMappedRegisters{});
    for (;;) {
        // The reset ends this, or else the watchdog, which nobody feeds any more.
    }
}

}  // namespace hal::zynqmp_r5

extern "C" [[noreturn]] void zynqmp_r5_on_exception(std::uint32_t exception, std::uint32_t instruction,
                                                    std::uint32_t program_status) {
    using namespace hal::zynqmp_r5;
    if (!is_handling) {
        is_handling = true;
        Fault fault = describe(static_cast<Exception>(exception));
        fault.instruction = instruction;
        fault.program_status = program_status;
        record_fault(fault, retained_record);
        on_fault(fault);
    }
    reset_now();
}
