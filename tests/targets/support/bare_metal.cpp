// Programs on a board without operating system: arguments, files and the end by semihosting.
#include <initializer_list>

#include "hal/semihosting/semihosting.hpp"
#include "tests/targets/support/program.hpp"

namespace semihosting = rsi::hal::semihosting;

namespace target {

Handle open_to_read(const char* path) {
    return semihosting::open(path, semihosting::OpenMode::read);
}
Handle open_to_write(const char* path) {
    return semihosting::open(path, semihosting::OpenMode::write);
}
std::size_t read(Handle file, void* bytes, std::size_t size) {
    return semihosting::read(file, bytes, size);
}
std::size_t write(Handle file, const void* bytes, std::size_t size) {
    return semihosting::write(file, bytes, size);
}
bool close(Handle file) {
    return semihosting::close(file);
}
void print(const char* text) {
    semihosting::print(text);
}

}  // namespace target

namespace {

constexpr int bad_command_line = 119;
constexpr int most_arguments = 16;

struct Arguments {
    char text[2048];
    const char* values[most_arguments + 1];  // a null pointer follows the last
    int count;
};

// Splits at the spaces; none may be within an argument.
bool fetch(Arguments& arguments) {
    if (!semihosting::command_line(arguments.text, sizeof(arguments.text))) {
        return false;
    }
    char before = ' ';
    for (char* character = arguments.text; *character != '\0'; ++character) {
        const bool begins = (before == ' ') && (*character != ' ');
        before = *character;
        if (*character == ' ') {
            *character = '\0';
        }
        if (begins) {
            if (arguments.count == most_arguments) {
                return false;
            }
            arguments.values[arguments.count] = character;
            ++arguments.count;
        }
    }
    return true;
}

}  // namespace

// A failed assertion (newlib calls this).
extern "C" [[noreturn]] void __assert_func(const char* file, int, const char*, const char* condition) {
    for (const char* text : {file, ": failed assertion: ", condition, "\n"}) {
        target::print(text);
    }
    semihosting::exit(bad_command_line);
}

int main() {
    static Arguments arguments{};
    if (!fetch(arguments)) {
        target::print("the command line is too long for the target\n");
        semihosting::exit(bad_command_line);
    }
    semihosting::exit(target::run(arguments.count, arguments.values));
}
