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

// Coprocessors 10 and 11, the FPU, for everybody (Armv7-M, coprocessor access control register).
void enable_fpu() {
    volatile std::uint32_t* const coprocessor_access =
        reinterpret_cast<volatile std::uint32_t*>(0xE000'ED88U);
    *coprocessor_access = *coprocessor_access | (0xFU << 20U);
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
    initialise_data();
    for (const Constructor* constructor = init_array_begin; constructor != init_array_end; ++constructor) {
        (*constructor)();
    }
    hal::semihosting::exit(program());
}
