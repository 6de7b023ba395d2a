// The exported self-test on every target; the exit status is its result. Use: selftest [flushing]
// flushing: with an FPU that flushes subnormal numbers to zero, operands and results, as other processors
// always do.
#include "selftest/selftest.h"

#include "tests/targets/support/flush_to_zero.hpp"
#include "tests/targets/support/program.hpp"

int target::run(int argc, const char* const*) {
    if (argc > 1) {
        flush_to_zero();
    }
    rsi_component component;
    return rsi_selftest(&component);
}
