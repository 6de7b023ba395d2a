/* The exit status is what rsi_selftest returns; with an argument it prints the header selftest_digest.h
 * instead. */
#include "selftest/selftest.h"

#include <stdio.h>

int main(int argc, char** argv) {
    rsi_component component;
    int result = 0;
    (void)argv;
    if (argc > 1) {
        const unsigned long digest = (unsigned long)rsi_selftest_digest(&component, &result);
        printf("/* Made by tests/targets/integration/renew; do not edit. */\n");
        printf("#define RSI_SELFTEST_EXPECTED_DIGEST 0x%08lXU\n", digest);
        return result;
    }
    if (!rsi_is_optimised()) {
        printf("the library was compiled without an optimiser\n");
    }
    return rsi_selftest(&component);
}
