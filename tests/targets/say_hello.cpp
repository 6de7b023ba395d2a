// What a target program can do: text, arguments, files, an exit status. The test of run_on_target.
#include <cstddef>

#include "tests/targets/support/program.hpp"

// say_hello IN OUT: copies the file IN to OUT; the exit status is the number of arguments.
int target::run(int argc, const char* const* argv) {
    print("hello\n");
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
