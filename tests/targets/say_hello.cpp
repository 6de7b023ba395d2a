// What a target program can do: text, arguments, files, an exit status, a fault. The test of run_on_target.
#include <cstddef>
#include <cstring>

#include "tests/targets/support/program.hpp"

// say_hello IN OUT: copies the file IN to OUT; say_hello fault: executes an undefined instruction. The exit
// status is the number of arguments, the name included.
int target::run(int argc, const char* const* argv) {
    print("hello\n");
    if ((argc == 2) && (std::strcmp(argv[1], "fault") == 0)) {
        __builtin_trap();
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
