// From reset to main: FPU, data, constructors; then the end.
#include <cstdint>

#include "hal/mps2/handlers.hpp"
#include "hal/semihosting/semihosting.hpp"

extern "C" {
int program() asm("main");  // C++ forbids a call of main() by its name
using Constructor = void (*)();
// Linker script
extern std::uint32_t data_begin[], data_end[], bss_begin[], bss_end[];
extern const std::uint32_t data_initial[];
extern const Constructor init_array_begin[], init_array_end[];
}

namespace {

volatile std::uint32_t& system_register(std::uintptr_t address) {
    return *reinterpret_cast<volatile std::uint32_t*>(address);
}

// Coprocessors 10 and 11, the FPU, full access (Armv7-M, coprocessor access control register).
void enable_fpu() {
    volatile std::uint32_t& coprocessor_access = system_register(0xE000'ED88U);
    coprocessor_access = coprocessor_access | (0xFU << 20U);
    asm volatile("dsb\n isb" : : : "memory");
}

// No access to the 64 KiB below the RAM, where a stack that overflows goes on; the board itself ignores it
// there (Armv7-M, memory protection unit). All else as without protection.
void guard_stack() {
    constexpr std::uint32_t valid = 1U << 4U;
    constexpr std::uint32_t size_64_kib = 15U << 1U;  // 2 to the power of 15 + 1
    constexpr std::uint32_t enable = 1U;
    constexpr std::uint32_t background = 1U << 2U;
    system_register(0xE000'ED9CU) = 0x1FFF'0000U | valid;  // base address of region 0
    system_register(0xE000'EDA0U) = size_64_kib | enable;  // attributes: no access
    system_register(0xE000'ED94U) = background | enable;   // control
    asm volatile("dsb\n isb" : : : "memory");
}

void initialise_data() {
    const std::uint32_t* from = data_initial;
    for (std::uint32_t* to = data_begin; to != data_end; ++to, ++from) {
        *to = *from;
    }
    for (std::uint32_t* to = bss_begin; to != bss_end; ++to) {
        *to = 0U;
    }
}

}  // namespace

extern "C" void reset() {
    enable_fpu();  // before any code that the compiler might give a floating-point register
    guard_stack();
    initialise_data();
    for (const Constructor* constructor = init_array_begin; constructor != init_array_end; ++constructor) {
        (*constructor)();
    }
    rsi::hal::semihosting::exit(program());
}
