// A program of the tests that runs on every target, and what it may ask of the machine that starts it: files
// and text, by semihosting on a board without operating system, by system calls on Linux.
#pragma once

#include <cstddef>

namespace target {

// The program gives this; the result (0 to 119) is its exit status. argv[0] is its name.
int run(int argc, const char* const* argv);

using Handle = int;
inline constexpr Handle no_file = -1;

// Relative to the folder in which the program (or its emulator) was started; no_file if refused.
Handle open_to_read(const char* path);
Handle open_to_write(const char* path);  // made or emptied

// Bytes read or written: fewer than `size` only at the end of the file or after an error.
std::size_t read(Handle file, void* bytes, std::size_t size);
std::size_t write(Handle file, const void* bytes, std::size_t size);

// False when what was written could not be kept.
bool close(Handle file);

// To the standard output.
void print(const char* text);

}  // namespace target
