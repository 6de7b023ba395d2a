// Write pace: when a record that its memory has not taken is tried again.
#pragma once

#include <cstdint>

namespace rsi::application {

// A memory may be busy for some cycles with the record before. One that refuses for longer is tried ever more
// rarely, at last once a minute: each try may cost it wear, and the bus to it time.
class WritePace {
 public:
    // Once a cycle of 10 ms.
    void begin_cycle() noexcept {
        if (left_ > 0U) {
            --left_;
        }
    }

    bool is_due() const noexcept { return left_ == 0U; }

    // Something waits for the record: the next try comes within so many cycles.
    void wait_at_most(std::uint32_t cycles) noexcept { left_ = (left_ < cycles) ? left_ : cycles; }

    // After each try.
    void tried(bool is_taken) noexcept {
        wait_ = is_taken ? 0U : longer_than(wait_);
        left_ = wait_;
    }

    // Refused for some seconds, and not taken since.
    bool is_failing() const noexcept { return wait_ >= wait_of_failure; }

 private:
    static constexpr std::uint32_t longest_wait = 6000U;
    static constexpr std::uint32_t wait_of_failure = 512U;  // after tries for as long as that

    static constexpr std::uint32_t longer_than(std::uint32_t wait) noexcept {
        if (wait == 0U) {
            return 1U;
        }
        return (wait < longest_wait / 2U) ? (2U * wait) : longest_wait;
    }

    std::uint32_t wait_{0U};  // between the last two tries, in cycles; 0: the last was taken
    std::uint32_t left_{0U};
};

}  // namespace rsi::application
