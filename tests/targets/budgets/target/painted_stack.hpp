// Painted stack: how far down a call wrote into the stack below its caller.
#pragma once

#include <stdint.h>

namespace budgets {

// Bytes below the stack pointer of the call, which is what the callee and all that it calls have used. No
// interrupt may be on. A word that is left as it was painted, at the far end, goes uncounted.
template <typename Call>
[[gnu::noinline]] uint32_t stack_used(Call call) {
    constexpr uint32_t paint = 0xA5C3'96E7U;
    constexpr uint32_t painted_bytes = 8192U;
    uint32_t top;
    asm volatile("mov %0, sp" : "=r"(top) : : "memory");
    const uint32_t bottom = top - painted_bytes;
    for (uint32_t at = bottom; at != top; at += 4U) {
        *reinterpret_cast<volatile uint32_t*>(at) = paint;
    }
    asm volatile("" : : : "memory");
    call();
    asm volatile("" : : : "memory");
    uint32_t lowest = bottom;
    while ((lowest != top) && (*reinterpret_cast<volatile uint32_t*>(lowest) == paint)) {
        lowest += 4U;
    }
    return top - lowest;
}

}  // namespace budgets
