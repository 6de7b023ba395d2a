// Signal check: range, jump and noise of one signal; a value that fails is bridged until its code is
// confirmed.
#pragma once

#include <cstdint>

#include "rsi/ecu/monitoring/diagnostic_memory.hpp"
#include "rsi/numeric/bounded.hpp"

namespace rsi::monitoring {

struct SignalLimits {
    float minimum;
    float maximum;
    float jump;   // largest change in one cycle
    float shake;  // largest mean of the change of the change, over 0.1 s
    DiagnosticCode invalid;
    DiagnosticCode jumps;
};

class SignalCheck {
 public:
    constexpr explicit SignalCheck(const SignalLimits& limits) noexcept : limits_{limits} {}

    // One value that its frame has brought. `expected_change` is what others say that it has changed by.
    // A value beyond its range, or further from the last good one than a cycle allows, or shaken, gives that
    // last one, until the code is confirmed; then NaN, until it is healed. NaN gives NaN at once.
    // `road_shake`: how far the road, which shakes others too, may shake it beyond its limit.
    float qualify(float value, DiagnosticMemory& memory, float expected_change = 0.0F,
                  float road_shake = 0.0F) noexcept;

    // Mean change of the change.
    float shake() const noexcept { return shake_; }

    // Noise of a good sensor, rms, besides what the limits admit: they grow by that of its second difference.
    void admit_noise(float rms) noexcept {
        const float second_difference = 2.45F * rms;
        limits_.jump += second_difference;
        limits_.shake += second_difference;
    }

    // A cycle without its frame.
    void forget() noexcept {
        known_ = false;
        values_ = 0U;
    }

 private:
    bool has_jumped(float value, float expected_change) const noexcept {
        return !rsi::is_within_magnitude(value - good_ - expected_change, limits_.jump);
    }

    bool is_shaken(float value, float road_shake) noexcept;

    void keep(float value) noexcept {
        good_ = value;
        known_ = true;
    }

    SignalLimits limits_;
    float good_{0.0F};
    bool known_{false};  // good_ is a value
    float last_{0.0F};   // as received, this one and the one before
    float before_{0.0F};
    std::uint32_t values_{0U};  // of these two, how many there are
    float shake_{0.0F};
};

}  // namespace rsi::monitoring
