/* Self-test of the component as the caller's own build has made it: compiler, flags and processor together.
 *
 * Compile selftest.c with the flags of the source that calls rsi_step, link it with the library, and run it
 * once on the target, with the FPU set up as for the application: static rsi_component component; if
 * (rsi_selftest(&component) != RSI_SELFTEST_PASSED) { ... } rsi_init(&component, &parameters);
 */
#ifndef SELFTEST_SELFTEST_H
#define SELFTEST_SELFTEST_H

#include "rsi/rsi.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Results of rsi_selftest: the first fault found. A library without an optimiser is none, but slow:
 * rsi_is_optimised in rsi.h. */
typedef enum {
    RSI_SELFTEST_PASSED = 0,
    /* isnan() or a comparison with NaN is wrong: compile this file, and whatever calls rsi_step, without
     * -ffast-math, -ffinite-math-only and, with clang, -fno-honor-nans. */
    RSI_SELFTEST_NAN = 1,
    /* The FPU does not round to nearest: set the rounding mode (Arm: FPSCR.RMode 0) before the first call. */
    RSI_SELFTEST_ROUNDING = 2,
    /* The FPU flushes subnormal numbers to zero, and the outputs differ: switch that off (Arm: FPSCR.FZ 0;
       x86: do not link with -ffast-math). If they still differ, see RSI_SELFTEST_DIGEST. */
    RSI_SELFTEST_FLUSH_TO_ZERO = 3,
    /* rsi_init refused the calibration large_suv: the header rsi.h and the library are of different
       revisions. */
    RSI_SELFTEST_PARAMETERS = 4,
    /* NaN in every input, and yet the component was available: the library was compiled without regard for
       NaN. */
    RSI_SELFTEST_AVAILABLE = 5,
    /* The outputs differ in at least one bit from those of a correct build: compile the library with
     * -ffp-contract=off and without flags that let the compiler reorder or approximate arithmetic. Or header
     * and library are of different revisions. */
    RSI_SELFTEST_DIGEST = 6,
    /* The FPU flushes subnormal numbers to zero, and yet every bit of the outputs is right. Not a fault where
     * an FPU knows nothing else (TriCore TC3xx, RH850): take it there for RSI_SELFTEST_PASSED. Elsewhere
     * switch it off all the same, as under RSI_SELFTEST_FLUSH_TO_ZERO. */
    RSI_SELFTEST_FLUSHED_SAME_BITS = 7
} rsi_selftest_result;

/* Steps `component`, which may be any storage, through a drive of ten seconds; call rsi_init afterwards.
 * Takes as long as a thousand steps; it needs no more stack than 1 KiB and what rsi_step needs, and no static
 * data. */
int rsi_selftest(rsi_component* component);

/* The number that the outputs of the drive are reduced to. For renewing selftest_digest.h. */
uint32_t rsi_selftest_digest(rsi_component* component, int* result);

#ifdef __cplusplus
}
#endif

#endif
