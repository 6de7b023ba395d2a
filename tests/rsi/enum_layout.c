/* The layout of rsi.h's structures as a C compiler has it. Compiled twice, with enumerations as small as they
 * can be
 * (-fshort-enums, the default of some bare-metal targets) and with those of an int: both must compile, and a
 * test compares what they say with C++. PROBE names the function. */
#include "tests/rsi/enum_layout.h"

#include <stddef.h>

#include "rsi/rsi.h"
#include "rsi/rsi_outputs.h"

#define SAME(condition, name) typedef char name[(condition) ? 1 : -1]

/* A field is four bytes and follows its neighbour, on every target. */
#define ROW(name, ...) +4U
SAME(sizeof(rsi_outputs) == 0U RSI_OUTPUTS(ROW, ROW, ROW), outputs_have_no_gaps);
SAME(sizeof(rsi_inputs) == 9U * 4U, inputs_have_no_gaps);
SAME(sizeof(rsi_learnt_load) == 3U * 4U, the_load_has_no_gaps);
SAME(sizeof(rsi_parameters) == offsetof(rsi_parameters, vehicle_motion_sensors) + 4U,
     parameters_have_no_tail);
SAME(offsetof(rsi_parameters, vehicle_motion_sensors) == offsetof(rsi_parameters, estimator) + 16U,
     choices_are_words);
SAME(offsetof(rsi_validation, field) == sizeof(void*), the_answer_is_padded_to_a_pointer);
SAME(sizeof(rsi_validation) == 3U * sizeof(void*), the_answer_has_no_tail);

/* The reason for compiling this file twice: in one of the two, an enumeration is smaller. */
unsigned PROBE(unsigned* numbers) {
    unsigned count = 0U;
#define OFFSET(name, ...) numbers[count++] = (unsigned)offsetof(rsi_outputs, name);
    RSI_OUTPUTS(OFFSET, OFFSET, OFFSET)
    numbers[count++] = (unsigned)sizeof(rsi_outputs);
    numbers[count++] = (unsigned)sizeof(rsi_parameters);
    numbers[count++] = (unsigned)sizeof(rsi_inputs);
    numbers[count++] = (unsigned)sizeof(rsi_validation);
    numbers[count] = (unsigned)sizeof(rsi_state);
    return count;
}
