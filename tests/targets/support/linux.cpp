// Programs on Linux: system calls.
#include <fcntl.h>
#include <unistd.h>

#include <cstring>

#include "tests/targets/support/program.hpp"

namespace target {

Handle open_to_read(const char* path) {
    return ::open(path, O_RDONLY | O_CLOEXEC);
}

Handle open_to_write(const char* path) {
    constexpr mode_t read_and_write = 0666;
    return ::open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, read_and_write);
}

std::size_t read(Handle file, void* bytes, std::size_t size) {
    std::size_t done = 0U;
    while (done < size) {
        const ssize_t got = ::read(file, static_cast<char*>(bytes) + done, size - done);
        if (got <= 0) {
            break;
        }
        done += static_cast<std::size_t>(got);
    }
    return done;
}

std::size_t write(Handle file, const void* bytes, std::size_t size) {
    std::size_t done = 0U;
    while (done < size) {
        const ssize_t put = ::write(file, static_cast<const char*>(bytes) + done, size - done);
        if (put <= 0) {
            break;
        }
        done += static_cast<std::size_t>(put);
    }
    return done;
}

bool close(Handle file) {
    return ::close(file) == 0;
}

void print(const char* text) {
    write(STDOUT_FILENO, text, std::strlen(text));
}

}  // namespace target

int main(int argc, char** argv) {
    return target::run(argc, argv);
}
