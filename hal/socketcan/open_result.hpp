// Result of opening a SocketCAN interface: what is wrong, where, and what to do next.
#pragma once

#include <array>
#include <cstdint>

namespace rsi::hal {

enum class OpenFailure : std::uint8_t {
    none,
    interface_name,  // empty, or longer than the kernel allows
    identifiers,     // an identifier out of range, or too many of them
    kernel_without_can,
    not_permitted,
    interface_missing,
    interface_not_can,
    interface_down,
    system,  // anything else; system_error tells
};

struct OpenResult {
    OpenFailure failure{OpenFailure::none};
    int system_error{0};  // errno of the call that failed, 0 when none did
    std::array<char, 480> text{};

    explicit operator bool() const noexcept { return failure == OpenFailure::none; }
    const char* message() const noexcept { return text.data(); }  // one paragraph; empty after success
};

// Writes the message for a failure on `interface_name`.
OpenResult describe_open_failure(OpenFailure failure, int system_error, const char* interface_name) noexcept;

}  // namespace rsi::hal
