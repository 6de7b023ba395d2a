/* An integrator's main loop, in C99, around the component: read the sensors, step, tell the driver.
 *
 * Tick, sensors and lamp are simulated here; in a real program the platform provides them. */
#include <math.h>
#include <stdio.h>

#include "calibrations/generated/large_suv.h"
#include "rsi/rsi.h"
#include "selftest/selftest.h"

/* A left turn that is too hard: straight on at 108 km/h for a second, then 9 m/s^2 within three quarters of
 * one. */
static void read_sensors(unsigned cycle, rsi_inputs* inputs) {
    const float time_s = (float)cycle * RSI_SAMPLE_TIME_S;
    const float turned = (time_s < 1.0F) ? 0.0F : ((time_s > 1.75F) ? 1.0F : (time_s - 1.0F) / 0.75F);
    const int turning_in = (turned > 0.0F) && (turned < 1.0F);
    inputs->lateral_specific_force_mps2 = 9.0F * turned;
    inputs->vertical_specific_force_mps2 = 9.81F;
    inputs->roll_angle_rad = 0.12F * turned;
    inputs->roll_rate_radps = turning_in ? 0.16F : 0.0F;
    inputs->yaw_rate_radps = 0.3F * turned;
    inputs->speed_mps = 30.0F;
    inputs->steering_wheel_angle_rad = 1.2F * turned;
    inputs->bank_angle_rad = NAN; /* no such sensor */
}

static void tell_the_driver(unsigned cycle, const rsi_outputs* outputs) {
    static const char* const states[] = {"unavailable", "ready", "advisory", "warning"};
    static const char* const sides[] = {"", ", left side", ", right side"};
    printf("%.2f s  %s%s\n", (double)((float)cycle * RSI_SAMPLE_TIME_S), states[outputs->state],
           sides[outputs->side]);
}

int main(void) {
    rsi_component component;
    const int selftest = rsi_selftest(&component);
    const rsi_validation answer = rsi_init(&component, &large_suv_parameters);
    int32_t last = RSI_STATE_UNAVAILABLE;
    unsigned cycle;

    if (selftest != RSI_SELFTEST_PASSED) {
        fprintf(stderr, "this build does not compute as it should: %d, see selftest/selftest.h\n", selftest);
        return 1;
    }
    if (!rsi_is_optimised()) {
        fprintf(stderr, "the component was compiled without an optimiser: it is right, but slow\n");
    }
    if (!answer.accepted) {
        fprintf(stderr, "the component refuses %s: it %s\n", answer.field, answer.reason);
        return 1;
    }
    for (cycle = 0U; cycle < 300U; ++cycle) { /* every 10 ms, when the platform's timer says so */
        rsi_inputs inputs;
        rsi_outputs outputs;
        read_sensors(cycle, &inputs);
        rsi_step(&component, &inputs, &outputs);
        if (outputs.state != last) {
            tell_the_driver(cycle, &outputs);
            last = outputs.state;
        }
    }
    return (last == RSI_STATE_WARNING) ? 0 : 1;
}
