// The component alone, without any library: it warns in a hard turn.
//
// That it links with -nostdlib proves that the component needs no allocator, no mathematical library, no
// exceptions and no output; the exit code says whether it works.
#include "rsi/rsi.h"
#include "tests/support/large_suv.h"
#include "tests/targets/freestanding/start.hpp"

namespace {

// State and side after two seconds at constant lateral force.
rsi_outputs after_turn(float lateral_specific_force_mps2, float roll_angle_rad) {
    const rsi_parameters parameters = rsi_test_large_suv();
    rsi_component component;
    rsi_outputs outputs{};
    if (rsi_init(&component, &parameters).accepted != 0) {
        rsi_inputs inputs{};
        inputs.lateral_specific_force_mps2 = lateral_specific_force_mps2;
        inputs.vertical_specific_force_mps2 = 9.80665F;
        inputs.roll_angle_rad = roll_angle_rad;
        for (int k = 0; k < 200; ++k) {
            rsi_step(&component, &inputs, &outputs);
        }
    }
    return outputs;
}

}  // namespace

extern "C" long run() {
    const rsi_outputs gentle = after_turn(2.0F, 0.02F);
    const rsi_outputs left_turn = after_turn(9.0F, 0.11F);
    const rsi_outputs right_turn = after_turn(-9.0F, -0.11F);
    if (gentle.state != RSI_STATE_READY) {
        return 1;
    }
    if ((left_turn.state != RSI_STATE_WARNING) || (left_turn.side != RSI_SIDE_RIGHT)) {
        return 2;
    }
    if ((right_turn.state != RSI_STATE_WARNING) || (right_turn.side != RSI_SIDE_LEFT)) {
        return 3;
    }
    return 0;
}
