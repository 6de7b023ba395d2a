// Semihosting: what a program on a bare Arm processor asks of the debugger or emulator that runs it: files,
// text, arguments, the end. For tests on a target only: without a debugger the call is a fault. Source: Arm,
// "Semihosting for AArch32 and AArch64", version 2.
#pragma once

#include <cstddef>

namespace rsi::hal::semihosting {

enum class OpenMode : unsigned char { read = 1U, write = 5U, append = 9U };  // fopen's "rb", "wb", "ab"

using Handle = int;
inline constexpr Handle no_file = -1;

// `path` is one of the machine that runs the emulator, relative to the emulator's own folder. no_file if
// refused.
Handle open(const char* path, OpenMode mode) noexcept;

// Bytes read, fewer than `size` only at the end of the file or after an error.
std::size_t read(Handle file, void* bytes, std::size_t size) noexcept;

// Bytes written, fewer than `size` only after an error.
std::size_t write(Handle file, const void* bytes, std::size_t size) noexcept;

// False when what was written could not be kept.
bool close(Handle file) noexcept;

// To the emulator's console.
void print(const char* text) noexcept;

// The program's name and arguments, one space between two, into `text` (ended by a zero). False when they do
// not fit.
bool command_line(char* text, std::size_t size) noexcept;

// Ends the emulator, whose exit status becomes `status` (0 to 255).
[[noreturn]] void exit(int status) noexcept;

}  // namespace rsi::hal::semihosting
