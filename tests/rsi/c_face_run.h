/* A C program's way of using the component, for the test of the C interface. */
#ifndef TESTS_UNIT_C_FACE_RUN_H
#define TESTS_UNIT_C_FACE_RUN_H

#include "rsi/rsi.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Starts a component on the stack and steps it through `count` inputs; returns the answer of rsi_init. */
rsi_validation c_face_run(const rsi_parameters* parameters, const rsi_inputs* inputs, rsi_outputs* outputs,
                          unsigned count);

/* The same with a change to `others` that begins at sample 100, is prepared once a sample and taken over when
 * it is ready, and a reset at sample 700. Returns how often it was prepared; 0: `others` were refused. */
unsigned c_face_change(const rsi_parameters* parameters, const rsi_parameters* others,
                       const rsi_inputs* inputs, rsi_outputs* outputs, unsigned count);

#ifdef __cplusplus
}
#endif

#endif
