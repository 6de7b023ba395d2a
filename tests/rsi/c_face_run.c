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
