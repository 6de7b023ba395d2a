/* The component's answers to a long pseudo-random drive, as numbers that are equal only if every bit is. */
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "calibrations/generated/large_suv.h"
#include "rsi/rsi.h"

static uint32_t state = 1U;

/* -1 to 1, the same on every target. */
static float noise(void) {
    state ^= state << 13U;
    state ^= state >> 17U;
    state ^= state << 5U;
    return (float)(int32_t)state * (1.0F / 2147483648.0F);
}

static float turn = 0.0F;

static void drive(rsi_inputs* inputs) {
    const float zero = turn * 0.0F;
    turn += 0.02F * (9.0F * noise() - 0.2F * turn);
    inputs->lateral_specific_force_mps2 = 3.0F * turn + 0.1F * noise();
    inputs->vertical_specific_force_mps2 = 9.81F + 0.2F * noise();
    inputs->roll_rate_radps = 0.1F * noise();
    inputs->roll_angle_rad = 0.04F * turn + 0.002F * noise();
    inputs->yaw_rate_radps = 0.1F * turn;
    inputs->bank_angle_rad = (noise() > 0.9F) ? 0.05F * noise() : zero / zero;
    inputs->speed_mps = 25.0F + noise();
    inputs->steering_wheel_angle_rad = (noise() < -0.9F) ? 1.0e9F : 0.5F * turn;
    inputs->vehicle_mass_kg = (noise() > 0.0F) ? 2500.0F + 500.0F * noise() : zero / zero;
}

/* NaN has many bit patterns, which mean the same. */
static uint32_t add(uint32_t sum, uint32_t word) {
    const uint32_t canonical = ((word & 0x7FFFFFFFU) > 0x7F800000U) ? 0x7FC00000U : word;
    return (sum ^ canonical) * 16777619U;
}

static uint32_t add_all(uint32_t sum, const rsi_outputs* outputs) {
    /* The numbers follow each other to the end; enumerations have another size from target to target. */
    uint32_t words[(sizeof *outputs - offsetof(rsi_outputs, warning_level)) / sizeof(uint32_t)];
    unsigned index;
    memcpy(words, &outputs->warning_level, sizeof words);
    for (index = 0U; index < sizeof words / sizeof words[0]; ++index) {
        sum = add(sum, words[index]);
    }
    sum = add(sum, (uint32_t)outputs->state);
    sum = add(sum, (uint32_t)outputs->side);
    sum = add(sum, (uint32_t)outputs->roll_source);
    sum = add(sum, (uint32_t)outputs->roll_sensor_disagrees);
    return add(sum, (uint32_t)outputs->estimate_frozen);
}

int main(void) {
    rsi_component component;
    uint32_t sum = 2166136261U;
    unsigned cycle;
    if (!rsi_init(&component, &large_suv_parameters).accepted) {
        return 1;
    }
    for (cycle = 1U; cycle <= 5000U; ++cycle) {
        rsi_inputs inputs;
        rsi_outputs outputs;
        drive(&inputs);
        rsi_step(&component, &inputs, &outputs);
        sum = add_all(sum, &outputs);
        if (cycle % 250U == 0U) {
            printf("%u %08lx state %d\n", cycle, (unsigned long)sum, (int)outputs.state);
        }
    }
    return 0;
}
