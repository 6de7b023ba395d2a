/* Compiler flags that the component refuses; rsi.h includes this, so that library and caller are both
 * checked.
 *
 * A compiler does not announce every such flag: contraction (-ffp-contract=fast, the default of GCC outside
 * -std=c99) is never announced, and clang announces few of the others. selftest/selftest.c finds them
 * when it runs. */
#ifndef RSI_FLOAT_RULES_H
#define RSI_FLOAT_RULES_H

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && (__FINITE_MATH_ONLY__ > 0))
#error "compile without -ffast-math, -Ofast and -ffinite-math-only: NaN means \"not available\" here"
#endif

/* The arithmetic of the component is in C++: its sources, and the headers that a C++ caller includes. */
#ifdef __cplusplus
#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error \
    "compile without -funsafe-math-optimizations, -fassociative-math, -freciprocal-math and -fno-signed-zeros"
#endif
#if defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ != 0)
#error "float must be computed as float: on x86 compile with -msse2 -mfpmath=sse"
#endif
#endif

#endif
