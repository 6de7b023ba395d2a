// Abilities of a target program: text, arguments, files, an exit status, a fault, a stack that overflows. The
// test of run_on_target.
#include <cstddef>
#include <cstring>

#include "tests/targets/support/program.hpp"

namespace {

// Goes deeper until the stack ends.
int go_deeper(const volatile int* caller, int depth) {
    volatile int here[100];
    here[depth % 100] = *caller;
    return depth == 0 ? here[0] : go_deeper(here, depth + 1) + here[0];
}

}  // namespace

// say_hello IN OUT: copies the file IN to OUT; say_hello fault: executes an undefined instruction;
// say_hello overflow: needs more stack than there is. Else the exit status is the number of arguments, the
// name included.
int target::run(int argc, const char* const* argv) {
    print("hello\n");
    if ((argc == 2) && (std::strcmp(argv[1], "fault") == 0)) {
        __builtin_trap();
    }
    if ((argc == 2) && (std::strcmp(argv[1], "overflow") == 0)) {
        const volatile int start = 1;
        return go_deeper(&start, 1);
    }
    if (argc != 3) {
        return argc;
    }
    const Handle in = open_to_read(argv[1]);
    const Handle out = open_to_write(argv[2]);
    char bytes[100];
    std::size_t size = sizeof(bytes);
    while (size == sizeof(bytes)) {
        size = read(in, bytes, sizeof(bytes));
        if (write(out, bytes, size) != size) {
            return 100;
        }
    }
    return (close(in) && close(out)) ? argc : 101;
}
