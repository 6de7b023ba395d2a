// Signal check: range, jump, noise and bursts of one signal; a value that fails is bridged until its code is
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
    // Largest change in one cycle, up and down, that is used at once; a larger one may begin a burst.
    float step_up{1.0e6F};
    float step_down{1.0e6F};
};

// Other signals' statements about the change of this one, finite.
struct SignalSupport {
    float expected_change{0.0F};  // since the value before
    float road_shake{0.0F};       // how far the road, which shakes others too, may shake it beyond its limit
    bool vehicle_is_calm{true};   // the body does not move as a true step of this signal would move it
};

class SignalCheck {
 public:
    constexpr explicit SignalCheck(const SignalLimits& limits) noexcept
        : limits_{limits}, codes_{set_of(limits.invalid, limits.jumps)} {}

    // One value that its frame has brought.
    // A value beyond its range, or further from the last good one than a cycle allows, or shaken, gives that
    // last one, until the code is confirmed; then NaN, until it is healed. NaN gives NaN at once.
    // A step of a calm vehicle gives the last good value, for 0.15 s at most. If the signal is back by then,
    // it was a burst; the third one, each within a minute of the one before, confirms the code of jumps.
    float qualify(float value, DiagnosticMemory& memory, const SignalSupport& support = {}) noexcept;

    // Last good value; that of before, once the signal is not there.
    float last_good() const noexcept { return good_; }

    // Mean change of the change.
    float shake() const noexcept { return shake_; }

    // Noise of a good sensor, rms, besides what the limits admit: they grow by that of its second difference.
    void admit_noise(float rms) noexcept {
        const float second_difference = 2.45F * rms;
        limits_.jump += second_difference;
        limits_.shake += second_difference;
        limits_.step_up += second_difference;
        limits_.step_down += second_difference;
    }

    // A cycle without its frame.
    void forget() noexcept {
        known_ = false;
        values_ = 0U;
        doubted_samples_ = 0U;
    }

 private:
    static constexpr std::uint32_t longest_doubt = 15U;  // from here on the other signals' votes decide

    bool has_jumped(float value, float expected_change) const noexcept {
        return !rsi::is_within_magnitude(value - good_ - expected_change, limits_.jump);
    }

    // Further from the last good value than a step.
    bool is_far(float value, const SignalSupport& support) const noexcept {
        const float change = value - good_ - support.expected_change;
        return !rsi::is_within(change, -limits_.step_down - support.road_shake,
                               limits_.step_up + support.road_shake);
    }

    bool is_doubted(float value, const SignalSupport& support) const noexcept {
        return support.vehicle_is_calm && (doubted_samples_ < longest_doubt) && is_far(value, support);
    }

    bool is_failing(const DiagnosticMemory& memory) const noexcept {
        return memory.confirmed(limits_.invalid) || memory.confirmed(limits_.jumps);
    }

    bool is_shaken(float value, float road_shake) noexcept;
    void count_burst(DiagnosticMemory& memory) noexcept;

    void keep(float value) noexcept {
        good_ = value;
        known_ = true;
        doubted_samples_ = 0U;
    }

    SignalLimits limits_;
    CodeSet codes_;
    float good_{0.0F};
    bool known_{false};  // good_ is a value
    float last_{0.0F};   // as received, this one and the one before
    float before_{0.0F};
    std::uint32_t values_{0U};  // of these two, how many there are
    float shake_{0.0F};
    std::uint32_t doubted_samples_{0U};  // since the value was last good
    std::uint32_t bursts_{0U};
    std::uint32_t calm_samples_{0U};  // since the last burst
};

}  // namespace rsi::monitoring
