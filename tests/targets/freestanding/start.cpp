// The start and the end of a process without any library.
#include "tests/targets/freestanding/start.hpp"

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

extern "C" [[noreturn]] void run_and_exit() {
    const long code = run();
    for (;;) {
        exit_process(code);
    }
}
