#include "hal/semihosting/semihosting.hpp"

#include <cstdint>

namespace rsi::hal::semihosting {
namespace {

enum class Operation : std::uint32_t {
    open = 0x01U,
    close = 0x02U,
    print = 0x04U,
    write = 0x05U,
    read = 0x06U,
    command_line = 0x15U,
    exit_extended = 0x20U,
};

using Word = std::uintptr_t;
static_assert(sizeof(Word) == 4U, "the calls below are those of 32-bit Arm");

constexpr Word application_exit = 0x20026U;

// Operation in r0, argument (mostly the address of a block of words) in r1, answer in r0.
Word call(Operation operation, const void* argument) noexcept {
    register std::uint32_t r0 asm("r0") = static_cast<std::uint32_t>(operation);
    register const void* r1 asm("r1") = argument;
#if defined(__thumb__)
    asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory", "cc");
#else
    asm volatile("svc 0x123456" : "+r"(r0) : "r"(r1) : "memory", "cc", "lr");
#endif
    return r0;
}

Word address(const void* pointer) noexcept {
    return reinterpret_cast<Word>(pointer);
}

std::size_t text_length(const char* text) noexcept {
    std::size_t length = 0U;
    while (text[length] != '\0') {
        ++length;
    }
    return length;
}

}  // namespace

Handle open(const char* path, OpenMode mode) noexcept {
    const Word block[] = {address(path), static_cast<Word>(mode), text_length(path)};
    return static_cast<Handle>(call(Operation::open, block));
}

std::size_t read(Handle file, void* bytes, std::size_t size) noexcept {
    const Word block[] = {static_cast<Word>(file), address(bytes), size};
    const std::size_t not_read = call(Operation::read, block);
    return not_read <= size ? size - not_read : 0U;
}

std::size_t write(Handle file, const void* bytes, std::size_t size) noexcept {
    const Word block[] = {static_cast<Word>(file), address(bytes), size};
    const std::size_t not_written = call(Operation::write, block);
    return not_written <= size ? size - not_written : 0U;
}

bool close(Handle file) noexcept {
    const Word block[] = {static_cast<Word>(file)};
    return call(Operation::close, block) == 0U;
}

void print(const char* text) noexcept {
    call(Operation::print, text);
}

bool command_line(char* text, std::size_t size) noexcept {
    Word block[] = {address(text), size};
    return call(Operation::command_line, block) == 0U;
}

void exit(int status) noexcept {
    const Word block[] = {application_exit, static_cast<Word>(status)};
    for (;;) {
        call(Operation::exit_extended, block);
    }
}

}  // namespace rsi::hal::semihosting
