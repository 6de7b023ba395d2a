// The reaction to every exception: record it, let the image say so on the bus, reset.
#include "hal/zynqmp_r5/startup/exceptions.hpp"

#include "hal/zynqmp_r5/data_abort.hpp"
#include "hal/zynqmp_r5/policy.hpp"
#include "hal/zynqmp_r5/registers.hpp"

namespace rsi::hal::zynqmp_r5 {
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
    start_without_reset = 8,
};

[[gnu::section(".retained")]] FaultRecord retained_record;

// Set from the first exception to the reset. The start clears it.
volatile bool is_handling = false;

std::uint32_t data_fault_status() {  // DFSR
    std::uint32_t status = 0U;
    asm volatile("mrc p15, 0, %0, c5, c0, 0" : "=r"(status));
    return status;
}

std::uint32_t data_fault_address() {  // DFAR
    std::uint32_t address = 0U;
    asm volatile("mrc p15, 0, %0, c6, c0, 0" : "=r"(address));
    return address;
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
            fault = describe_data_abort(data_fault_status(), data_fault_address());
            break;
        case Exception::start_without_reset:
            fault.reason = ResetReason::start_without_reset;
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
        // The reset ends this, or else the watchdog, which is not fed any more.
    }
}

}  // namespace rsi::hal::zynqmp_r5

extern "C" [[noreturn]] void zynqmp_r5_on_exception(std::uint32_t exception, std::uint32_t instruction,
                                                    std::uint32_t program_status) {
    using namespace rsi::hal::zynqmp_r5;
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
