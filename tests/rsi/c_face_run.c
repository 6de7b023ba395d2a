/* Compiled as C99: the component used from C. */
#include "tests/rsi/c_face_run.h"

rsi_validation c_face_run(const rsi_parameters* parameters, const rsi_inputs* inputs, rsi_outputs* outputs,
                          unsigned count) {
    rsi_component component;
    const rsi_validation answer = rsi_init(&component, parameters);
    unsigned k;
    for (k = 0U; k < count; ++k) {
        rsi_step(&component, &inputs[k], &outputs[k]);
    }
    return answer;
}

unsigned c_face_change(const rsi_parameters* parameters, const rsi_parameters* others,
                       const rsi_inputs* inputs, rsi_outputs* outputs, unsigned count) {
    rsi_component component;
    rsi_parameter_change change;
    const rsi_parameters* in_use = parameters;
    int is_prepared = 0;
    unsigned preparations = 0U;
    unsigned k;
    rsi_init(&component, parameters);
    for (k = 0U; k < count; ++k) {
        if (k == 100U) {
            is_prepared = rsi_begin_change(&change, parameters, others).accepted;
        }
        if (is_prepared) {
            ++preparations;
            if (rsi_prepare_change(&change)) {
                rsi_change(&component, &change);
                in_use = others;
                is_prepared = 0;
            }
        }
        if (k == 700U) {
            rsi_reset(&component, in_use);
        }
        rsi_step(&component, &inputs[k], &outputs[k]);
    }
    return preparations;
}
