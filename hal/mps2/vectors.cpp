// Vector table of the Cortex-M: the first two words are the initial stack pointer and the reset handler.
#include <cstdint>

#include "hal/mps2/handlers.hpp"

extern "C" std::uint32_t stack_top[];  // linker script

namespace {

using Handler = void (*)();

struct VectorTable {
    std::uint32_t* initial_stack;
    Handler exceptions[15];  // of the core: reset, NMI, faults, SVC, SysTick
};

}  // namespace

extern "C" const VectorTable vectors;
// Interrupts of peripherals stay disabled and have no entry.
__attribute__((section(".vectors"), used))
const VectorTable vectors{stack_top,
                          {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
                           fault, fault, system_tick}};
