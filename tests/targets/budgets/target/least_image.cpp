// The least image: start-up, rsi_init, rsi_step and nothing else, to see how large the library is in an image
// and what it draws in.
#include "rsi/rsi.h"

namespace {

rsi_component component;
rsi_parameters parameters;
rsi_inputs inputs;
rsi_outputs outputs;

// Values that a compiler must take as changed elsewhere.
template <typename Value>
Value* opaque(Value& value) {
    Value* pointer = &value;
    asm volatile("" : "+r"(pointer) : : "memory");
    return pointer;
}

}  // namespace

int main() {
    const rsi_validation answer = rsi_init(opaque(component), opaque(parameters));
    rsi_step(opaque(component), opaque(inputs), opaque(outputs));
    return answer.accepted;
}
