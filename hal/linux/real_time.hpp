// Real time: asks Linux for a real-time priority and for memory that is never paged out.
#pragma once

#include <array>
#include <cstdint>

namespace rsi::hal {

struct RealTimeSettings {
    int fifo_priority{0};     // 1 to 99 under SCHED_FIFO; 0 leaves the scheduling as it is
    bool lock_memory{false};  // lock all present and future pages (mlockall)
};

enum class RealTimeFailure : std::uint8_t { none, priority_out_of_range, scheduling, memory };

struct RealTimeResult {
    RealTimeFailure failure{RealTimeFailure::none};
    int system_error{0};  // errno of the call that failed
    std::array<char, 320> text{};

    explicit operator bool() const noexcept { return failure == RealTimeFailure::none; }
    const char* message() const noexcept { return text.data(); }  // empty after success
};

// Applies the settings to the calling thread (priority) and the process (memory). Call it once, after
// everything has been set up and before the loop. Memory is locked first; what was granted before a failure
// stays in force, so that a program may report the message and go on without.
RealTimeResult enter_real_time(const RealTimeSettings& settings) noexcept;

}  // namespace rsi::hal
