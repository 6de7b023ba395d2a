// Errors that end the run: faults, unexpected exceptions, failed assertions.
#include <cstdint>

#include "hal/mps2/handlers.hpp"
#include "hal/semihosting/semihosting.hpp"

namespace {

constexpr int fault_status = 120;  // exit status of the emulator, unlike any that a test returns

}  // namespace

extern "C" {

extern std::uint32_t stack_top[];  // linker script

[[noreturn]] __attribute__((used)) void report_fault() {
    rsi::hal::semihosting::print("mps2: a fault or an unexpected exception ended the program\n");
    rsi::hal::semihosting::exit(fault_status);
}

// The stack may be what is broken: begin it anew.
__attribute__((naked)) void fault() {
    asm volatile("ldr r0, =stack_top\n mov sp, r0\n b report_fault\n");
}

__attribute__((weak)) void system_tick() {}
}
