// Instruction counter: a timer of the processor, read before and after. Under an emulator in which every
// instruction takes the same time its ticks are instructions.
#pragma once

#include <stdint.h>

namespace budgets {

#if defined(__ARM_ARCH_PROFILE) && (__ARM_ARCH_PROFILE == 'M')

// SysTick (Armv7-M), which counts down in 24 bits at the processor's clock.
class InstructionCounter {
 public:
    static void start() {
        *address(reload_) = mask_;
        *address(value_) = 0U;
        *address(control_) = 5U;  // on, processor's clock, no exception
    }
    static uint32_t now() { return *address(value_); }
    static uint32_t between(uint32_t before, uint32_t after) { return (before - after) & mask_; }

 private:
    static constexpr uint32_t control_ = 0xE000E010U;
    static constexpr uint32_t reload_ = 0xE000E014U;
    static constexpr uint32_t value_ = 0xE000E018U;
    static constexpr uint32_t mask_ = 0xFFFFFFU;
    static volatile uint32_t* address(uint32_t number) {
        return reinterpret_cast<volatile uint32_t*>(number);
    }
};

#elif defined(__ARM_ARCH) && (__ARM_ARCH == 7)

// Cycle counter of the performance monitors (Armv7-A and -R).
class InstructionCounter {
 public:
    static void start() {
        asm volatile("mcr p15, 0, %0, c9, c12, 0" : : "r"(7U));           // PMCR: on, both reset
        asm volatile("mcr p15, 0, %0, c9, c12, 1" : : "r"(0x80000001U));  // PMCNTENSET: the cycle counter
    }
    static uint32_t now() {
        uint32_t count;
        asm volatile("mrc p15, 0, %0, c9, c13, 0" : "=r"(count) : : "memory");
        return count;
    }
    static uint32_t between(uint32_t before, uint32_t after) { return after - before; }
};

#else
#error "add the counter of this processor"
#endif

}  // namespace budgets
