// Time: monotonic, in nanoseconds since an arbitrary start.
#pragma once

#include <cstdint>

namespace rsi::hal {

struct Time {
    std::int64_t nanoseconds{0};

    static constexpr Time from_milliseconds(std::int64_t milliseconds) {
        return Time{milliseconds * 1'000'000};
    }
};

constexpr bool operator==(Time a, Time b) {
    return a.nanoseconds == b.nanoseconds;
}
constexpr bool operator<(Time a, Time b) {
    return a.nanoseconds < b.nanoseconds;
}
constexpr Time operator-(Time a, Time b) {
    return Time{a.nanoseconds - b.nanoseconds};
}
constexpr Time operator+(Time a, Time b) {
    return Time{a.nanoseconds + b.nanoseconds};
}

class Clock {
 public:
    Clock(const Clock&) = delete;
    Clock& operator=(const Clock&) = delete;

    virtual Time now() const noexcept = 0;

 protected:
    Clock() = default;
    ~Clock() = default;
};

}  // namespace rsi::hal
