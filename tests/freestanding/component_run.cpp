// A whole program around the component without any library: it starts itself, warns in a hard turn, and ends.
//
// That it links with -nostdlib proves that the component needs no allocator, no mathematical library, no
// exceptions and no output; the exit code says whether it works.
#include "rsi/rsi.h"

extern "C" [[noreturn]] void run_and_exit();

#if defined(__x86_64__)
asm(".globl _start\n_start:\n  xor %ebp, %ebp\n  call run_and_exit\n");

static void exit_process(long code) {
    constexpr long exit_group = 231;
    asm volatile("syscall" : : "a"(exit_group), "D"(code) : "rcx", "r11", "memory");
}
#elif defined(__aarch64__)
asm(".globl _start\n_start:\n  mov x29, #0\n  bl run_and_exit\n");

static void exit_process(long code) {
    register long call asm("x8") = 94;  // exit_group
    register long argument asm("x0") = code;
    asm volatile("svc #0" : : "r"(call), "r"(argument) : "memory");
}
#else
#error "add the start of a process for this architecture"
#endif

namespace {

rsi_parameters large_suv() {
    rsi_parameters parameters{};
    parameters.sprung_mass_kg = 2060.0F;
    parameters.sprung_cg_height_m = 0.988F;
    parameters.track_width_m = 1.6F;
    parameters.fixed_roll_centre_height_m = 0.281F;
    parameters.roll_stiffness_nmprad = 96.0e3F;
    parameters.roll_damping_nmsprad = 8.0e3F;
    parameters.forgetting_factor = 0.999F;
    parameters.regression_scale_nm = 450.0F;
    parameters.initial_roll_centre_deviation_m = 0.1F;
    parameters.initial_stiffness_deviation_nmprad = 1.0e4F;
    parameters.initial_damping_deviation_nmsprad = 1.0e3F;
    parameters.covariance_limit = 100.0F;
    parameters.advisory_on = 0.8F;
    parameters.advisory_off = 0.7F;
    parameters.warning_on = 1.0F;
    parameters.warning_off = 0.9F;
    return parameters;
}

// State and side after two seconds at constant lateral force.
rsi_outputs after_turn(float lateral_specific_force_mps2, float roll_angle_rad) {
    const rsi_parameters parameters = large_suv();
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

// 0 when all is well, else the number of the expectation that failed.
extern "C" [[noreturn]] void run_and_exit() {
    const rsi_outputs gentle = after_turn(2.0F, 0.02F);
    const rsi_outputs left_turn = after_turn(9.0F, 0.11F);
    const rsi_outputs right_turn = after_turn(-9.0F, -0.11F);
    long code = 0;
    if (gentle.state != RSI_STATE_READY) {
        code = 1;
    } else if ((left_turn.state != RSI_STATE_WARNING) || (left_turn.side != RSI_SIDE_RIGHT)) {
        code = 2;
    } else if ((right_turn.state != RSI_STATE_WARNING) || (right_turn.side != RSI_SIDE_LEFT)) {
        code = 3;
    }
    for (;;) {
        exit_process(code);
    }
}
