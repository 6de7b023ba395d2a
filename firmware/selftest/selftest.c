/* C99; nothing of the C library but memcpy, memset and the macro isnan. See selftest.h. */
#include "selftest/selftest.h"

#include <math.h>
#include <string.h>

#include "calibrations/generated/large_suv.h"
#include "selftest/selftest_digest.h"

enum { steps = 480, steps_without_sensors = 10 };

static float float_of(uint32_t bits) {
    float value;
    (void)memcpy(&value, &bits, sizeof value);
    return value;
}

static uint32_t bits_of(float value) {
    uint32_t bits;
    (void)memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* Volatile: what is known at compile time is computed by the compiler and not by this processor. */
static int nan_is_seen(void) {
    const volatile uint32_t bits = 0x7FC00000U;
    const float not_available = float_of(bits);
    return isnan(not_available) && (not_available != not_available) && !(not_available >= 0.0F) &&
           !(not_available < 0.0F);
}

static int rounds_to_nearest(void) {
    const volatile float one = 1.0F;
    const volatile float less_than_half = 0x0.8p-24F;
    const volatile float more_than_half = 0x1.8p-24F;
    const volatile float up = one + less_than_half;
    const volatile float down = one + more_than_half;
    const volatile float negative = -one - less_than_half;
    return (bits_of(up) == 0x3F800000U) && (bits_of(down) == 0x3F800001U) &&
           (bits_of(negative) == 0xBF800000U);
}

static int keeps_subnormals(void) {
    const volatile uint32_t smallest_normal = 0x00800000U;
    const volatile uint32_t subnormal = 0x00400000U;
    const volatile float half = 0.5F;
    const volatile float two = 2.0F;
    const volatile float result = float_of(smallest_normal) * half;
    const volatile float operand = float_of(subnormal) * two;
    return (bits_of(result) == subnormal) && (bits_of(operand) == smallest_normal);
}

/* Pseudo-random integer from -range to range. */
static int32_t noise(uint32_t* state, int32_t range) {
    uint32_t drawn;
    *state ^= *state << 13U;
    *state ^= *state >> 17U;
    *state ^= *state << 5U;
    drawn = (*state >> 8U) % ((2U * (uint32_t)range) + 1U);
    return (int32_t)drawn - range;
}

/* The drive is computed in integers, in units of 2^-16, so that the flags of this file cannot change it. */
static float value_of(int32_t fixed) {
    return (float)fixed * 0x1p-16F;
}

typedef struct {
    uint32_t noise;
    int32_t turn; /* -65536 to 65536: the hardest right to the hardest left turn */
} drive_state;

/* Straight on, until the filter knows its offset; a gentle left turn, in which it learns; a hard one up to
 * the warning, over to the right, and back. */
static int32_t turn_asked_for(int32_t step) {
    if (step < 100) {
        return 0;
    }
    if (step < 190) {
        return 26000;
    }
    if (step < 260) {
        return 65536;
    }
    return (step < 360) ? -58000 : ((step < 420) ? 20000 : 0);
}

static void drive(drive_state* state, int32_t step, rsi_inputs* inputs) {
    const float not_available = float_of(0x7FC00000U);
    const int32_t difference = turn_asked_for(step) - state->turn;
    const int32_t change = (difference > 2500) ? 2500 : ((difference < -2500) ? -2500 : difference);
    state->turn += change;
    inputs->lateral_specific_force_mps2 = value_of((9 * state->turn) + noise(&state->noise, 6000));
    inputs->vertical_specific_force_mps2 = value_of(642908 + noise(&state->noise, 13000));
    inputs->roll_rate_radps = value_of((9 * change) + noise(&state->noise, 600));
    inputs->roll_angle_rad = value_of((state->turn / 9) + noise(&state->noise, 150));
    inputs->yaw_rate_radps = value_of((state->turn / 3) + noise(&state->noise, 300));
    inputs->bank_angle_rad = not_available;
    inputs->speed_mps = value_of((25 * 65536) + noise(&state->noise, 200));
    inputs->steering_wheel_angle_rad = value_of((2 * state->turn) + noise(&state->noise, 700));
    inputs->vehicle_mass_kg = (step < 150) ? not_available : value_of(2700 * 65536);

    /* Every sensor that may be missing is, at some time, and so is a short time all of them. */
    if (step < steps_without_sensors) {
        inputs->lateral_specific_force_mps2 = not_available;
        inputs->vertical_specific_force_mps2 = not_available;
        inputs->roll_rate_radps = not_available;
        inputs->roll_angle_rad = not_available;
        inputs->yaw_rate_radps = not_available;
        inputs->speed_mps = not_available;
        inputs->steering_wheel_angle_rad = not_available;
    }
    if ((step >= 220) && (step < 270)) {
        inputs->roll_angle_rad = not_available;
    }
    if ((step >= 290) && (step < 305)) {
        inputs->vertical_specific_force_mps2 = value_of(70 * 65536); /* out of range */
    }
    if ((step >= 310) && (step < 320)) {
        inputs->steering_wheel_angle_rad = not_available;
    }
    if ((step >= 370) && (step < 410)) {
        inputs->bank_angle_rad = value_of(step * 10);
    }
}

/* FNV-1a over words. NaN has many bit patterns, which mean the same. */
static uint32_t add(uint32_t digest, uint32_t word) {
    const uint32_t canonical = ((word & 0x7FFFFFFFU) > 0x7F800000U) ? 0x7FC00000U : word;
    return (digest ^ canonical) * 16777619U;
}

/* Every member has four bytes. */
static uint32_t add_outputs(uint32_t digest, const rsi_outputs* outputs) {
    uint32_t words[sizeof(rsi_outputs) / sizeof(uint32_t)];
    uint32_t sum = digest;
    uint32_t place;
    (void)memcpy(words, outputs, sizeof words);
    for (place = 0U; place < (sizeof(words) / sizeof(words[0])); ++place) {
        sum = add(sum, words[place]);
    }
    return sum;
}

/* One drive with one estimator, added to `digest`. */
static uint32_t add_drive(uint32_t digest, rsi_component* component, int32_t estimator, int* result) {
    rsi_parameters parameters = large_suv_parameters;
    drive_state state = {1U, 0};
    uint32_t sum = digest;
    int32_t step;
    parameters.estimator = estimator;
    if (rsi_init(component, &parameters).accepted != 1) {
        *result = RSI_SELFTEST_PARAMETERS;
        return sum;
    }
    for (step = 0; step < steps; ++step) {
        rsi_inputs inputs;
        rsi_outputs outputs;
        (void)memset(&outputs, 0, sizeof outputs);
        drive(&state, step, &inputs);
        rsi_step(component, &inputs, &outputs);
        sum = add_outputs(sum, &outputs);
        if ((step < steps_without_sensors) &&
            ((outputs.state != (int32_t)RSI_STATE_UNAVAILABLE) || !isnan(outputs.rsi))) {
            *result = RSI_SELFTEST_AVAILABLE;
        }
    }
    return sum;
}

uint32_t rsi_selftest_digest(rsi_component* component, int* result) {
    const uint32_t published = add_drive(2166136261U, component, RSI_ESTIMATOR_PUBLISHED, result);
    return add_drive(published, component, RSI_ESTIMATOR_CONSIDER_KALMAN, result);
}

int rsi_selftest(rsi_component* component) {
    int result = RSI_SELFTEST_PASSED;
    uint32_t digest;
    if (!nan_is_seen()) {
        return RSI_SELFTEST_NAN;
    }
    if (!rounds_to_nearest()) {
        return RSI_SELFTEST_ROUNDING;
    }
    digest = rsi_selftest_digest(component, &result);
    if (result != (int)RSI_SELFTEST_PASSED) {
        return result;
    }
    if (digest == RSI_SELFTEST_EXPECTED_DIGEST) {
        return keeps_subnormals() ? RSI_SELFTEST_PASSED : RSI_SELFTEST_FLUSHED_SAME_BITS;
    }
    return keeps_subnormals() ? RSI_SELFTEST_DIGEST : RSI_SELFTEST_FLUSH_TO_ZERO;
}
