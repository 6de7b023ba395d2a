/* C interface of the component with its calibrations and indices, for Python (rsi_component/component.py).
 * Structures are those of rsi/rsi.h; the judge is in sil/judge/judge.h. Times in s; NaN: there is none. */
#ifndef SIL_EXCHANGE_WHEEL_COMPONENT_H
#define SIL_EXCHANGE_WHEEL_COMPONENT_H

#include <stddef.h>
#include <stdint.h>

#include "rsi/rsi.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A field of a structure, or an index; in the order of the structure, or of rsi_indicator. */
typedef struct {
    const char* name;
    const char* meaning; /* for a selection its choices, with a comma between */
} component_field;

enum {
    COMPONENT_INPUT = 0,     /* float */
    COMPONENT_CODE = 1,      /* int32_t, before the numbers of rsi_outputs */
    COMPONENT_NUMBER = 2,    /* float */
    COMPONENT_PARAMETER = 3, /* float, before the selections of rsi_parameters */
    COMPONENT_SELECTION = 4, /* int32_t */
    COMPONENT_INDEX = 5
};
size_t component_field_count(int kind);
component_field component_field_at(int kind, size_t place);

/* From a calibration file, with changes in place of what it says, each KEY=VALUE. Returns 1; or 0, and why
 * not in the `room` bytes of `refusal`. */
int component_load(const char* path, size_t changes, const char* const* texts, rsi_parameters* parameters,
                   char* refusal, size_t room);

extern const size_t component_size; /* of rsi_component; to be aligned for 8 bytes */
extern const char* const component_version;

/* Starts a component with parameters of component_load. */
void component_start(rsi_component* component, const rsi_parameters* parameters);

/* Level (1 where it says "warn"; NaN: none) and side (< 0: the vehicle would fall to the left) of an index.
 */
typedef struct {
    float level;
    float side;
    float opposite; /* level towards the other side, for an index that knows both */
} component_risk;

/* One step a cycle. `risks` has one of every index for each cycle. */
void component_steps(rsi_component* component, const rsi_parameters* parameters, size_t cycles,
                     const rsi_inputs* inputs, rsi_outputs* outputs, component_risk* risks);

/* One index over a drive: every component_field_count(COMPONENT_INDEX)th of `risks` from `index` on. */
typedef struct {
    const rsi_parameters* parameters;
    size_t cycles;
    const double* times_s;
    const component_risk* risks;
    size_t index;
} component_course;

/* The index behind a copy of the firmware's warning states, as in sil/judge/index_score.hpp. */
double component_index_lead_s(const component_course* course, double threshold, double lift_off_time_s,
                              uint8_t falling_side);
int component_index_alarms(const component_course* course, double threshold);
double component_alarm_threshold(const component_course* course);

typedef struct {
    double threshold;
    double threshold_100ms;
    double threshold_200ms;
    double lead_s; /* with the threshold at 1 */
} component_score;
component_score component_index_score(const component_course* course, double lift_off_time_s,
                                      uint8_t falling_side);

typedef struct {
    double one_wheel_s;
    double two_wheel_s;
    double up_below_n; /* a wheel that carries less is up; NaN without wheel loads */
    uint8_t falling_side;
} component_lift_off;

/* By the wheel loads: front left, front right, rear left, rear right. The lateral acceleration decides where
 * both sides are up; it may be null. */
component_lift_off component_find_lift_off(size_t cycles, const double* times_s,
                                           const double* const* wheel_loads_n,
                                           const double* lateral_acceleration_mps2,
                                           double* load_transfer_ratios);

#ifdef __cplusplus
}
#endif
#endif
