// The exported self-test on every target; the exit status is its result.
#include "selftest/selftest.h"

#include "tests/targets/support/program.hpp"

int target::run(int, const char* const*) {
    rsi_component component;
    return rsi_selftest(&component);
}
