// Channel: the two ends of one protected message, for any profile.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/can_dbc/e2e/check_status.hpp"

namespace rsi::can_dbc::e2e {

// Judges the counters of undamaged frames as they arrive; every profile with a counter uses it.
// `range`: how many values the counter takes before it starts again at 0.
//
// The first frame is ok: nothing is known to be lost before it. Every frame becomes the reference of the next
// one, whatever its status, so that a jump of the counter costs one frame and never locks the receiver.
template <unsigned range>
class CounterSequence {
    static_assert(range >= 2U && range <= 256U, "the counter has to fit into a byte");

 public:
    // `largest_step` is how far the counter may advance between two frames, 1 to range - 1: 1 tolerates no
    // lost frame.
    constexpr explicit CounterSequence(std::uint8_t largest_step) : largest_step_{largest_step} {}

    // `counter` is 0 to range - 1.
    constexpr CheckResult follow(std::uint8_t counter) {
        const unsigned step = (counter + range - counter_) % range;
        const bool first = !has_reference_;
        has_reference_ = true;
        counter_ = counter;
        if (first || step == 1U) {
            return CheckResult{CheckStatus::ok};
        }
        if (step == 0U) {
            return CheckResult{CheckStatus::repeated};
        }
        const CheckStatus status =
            step <= largest_step_ ? CheckStatus::ok_some_lost : CheckStatus::wrong_sequence;
        return CheckResult{status, CheckError::none, static_cast<std::uint8_t>(step - 1U)};
    }

 private:
    std::uint8_t largest_step_;
    std::uint8_t counter_{0U};
    bool has_reference_{false};
};

// A profile is a struct of static functions and constants:
//
// - `counter_range`: the counter is 0 to counter_range - 1
// - `protect(payload, data_id, counter)`: writes counter and CRC into an array that holds its signals
// - `verify(payload, length, expected_length, data_id)`: what is wrong with a payload, but for the sequence
// - `counter(payload)`: of a payload that has been verified

// Protects the frames of one sender and one data identifier, counting them. The caller owns it, one a
// message.
template <typename Profile>
class Sender {
 public:
    constexpr explicit Sender(std::uint16_t data_id) : data_id_{data_id} {}

    template <std::size_t size>
    constexpr void protect(std::array<std::uint8_t, size>& payload) {
        Profile::protect(payload, data_id_, counter_);
        const unsigned next = counter_ + 1U;
        counter_ = static_cast<std::uint8_t>((next < Profile::counter_range) ? next : 0U);
    }

 private:
    std::uint16_t data_id_;
    std::uint8_t counter_{0U};
};

// Checks the frames of one data identifier as they arrive. The caller owns it, one a message. A damaged frame
// leaves the counter's reference alone; see CounterSequence. StateMachine, which watches several cycles, is
// fed with the results of `check` and `no_frame`.
template <typename Profile>
class Receiver {
 public:
    // `largest_counter_step` is how far the counter may advance between two frames, 1 to counter_range - 1: 1
    // tolerates no lost frame.
    constexpr Receiver(std::uint16_t data_id, std::size_t length, std::uint8_t largest_counter_step)
        : length_{length}, data_id_{data_id}, sequence_{largest_counter_step} {}

    // Judges one received frame: `length` is the frame's, which may be smaller than the array.
    template <std::size_t size>
    constexpr CheckResult check(const std::array<std::uint8_t, size>& payload, std::size_t length) {
        return length > size ? CheckResult{CheckStatus::error, CheckError::length}
                             : check(payload.data(), length);
    }

    // The outcome of a cycle without a frame.
    constexpr CheckResult no_frame() const { return CheckResult{}; }

 private:
    constexpr CheckResult check(const std::uint8_t* payload, std::size_t length) {
        const CheckError error = Profile::verify(payload, length, length_, data_id_);
        return error == CheckError::none ? sequence_.follow(Profile::counter(payload))
                                         : CheckResult{CheckStatus::error, error};
    }

    std::size_t length_;
    std::uint16_t data_id_;
    CounterSequence<Profile::counter_range> sequence_;
};

}  // namespace rsi::can_dbc::e2e
