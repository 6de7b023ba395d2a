// Makes the FPU flush subnormal numbers to zero, operands and results, where it can; elsewhere nothing
// changes.
#pragma once

#include <cstdint>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace target {

inline void flush_to_zero() {
#if defined(__SSE__)
    _mm_setcsr(_mm_getcsr() | 0x8040U);  // FTZ, DAZ
#elif defined(__aarch64__)
    std::uint64_t control = 0U;
    __asm volatile("mrs %0, fpcr" : "=r"(control));
    __asm volatile("msr fpcr, %0" : : "r"(control | (1ULL << 24U)));  // FZ
#elif defined(__arm__)
    std::uint32_t control = 0U;
    __asm volatile("vmrs %0, fpscr" : "=r"(control));
    __asm volatile("vmsr fpscr, %0" : : "r"(control | (1UL << 24U)));  // FZ
#endif
}

}  // namespace target
