/* The component in a program of one's own: a hard left turn must end in a warning for the right side. */
#include <stdio.h>

#include "rsi/rsi.h"
#include "selftest/selftest.h"
#include "tests/support/large_suv.h"

int main(void) {
    rsi_component component;
    const rsi_parameters parameters = rsi_test_large_suv();
    const rsi_validation answer = rsi_init(&component, &parameters);
    rsi_inputs inputs = {0};
    rsi_outputs outputs = {0};
    int k;

    if (rsi_selftest(&component) != RSI_SELFTEST_PASSED) {
        fprintf(stderr, "the self-test fails\n");
        return 1;
    }
    (void)rsi_init(&component, &parameters);
    if (!answer.accepted) {
        fprintf(stderr, "%s %s\n", answer.field, answer.reason);
        return 1;
    }
    inputs.lateral_specific_force_mps2 = 9.0F;
    inputs.vertical_specific_force_mps2 = 9.81F;
    inputs.roll_angle_rad = 0.11F;
    for (k = 0; k < 200; ++k) {
        rsi_step(&component, &inputs, &outputs);
    }
    printf("state %d, side %d, RSI %.2f\n", (int)outputs.state, (int)outputs.side, (double)outputs.rsi);
    return (outputs.state == RSI_STATE_WARNING && outputs.side == RSI_SIDE_RIGHT) ? 0 : 1;
}
