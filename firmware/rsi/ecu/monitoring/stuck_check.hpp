// Stuck check: the very same value again and again, while another signal shows that it must move.
#pragma once

#include <cstdint>

#include "rsi/ecu/monitoring/repetition.hpp"
#include "rsi/numeric/bounded.hpp"

namespace rsi::monitoring {

class StuckCheck {
 public:
    // `reference_span`: how far the reference has to move while the value does not; `drift`: how much further
    // for each cycle that the value repeats itself beyond a second, because the reference goes on by itself.
    constexpr explicit StuckCheck(float reference_span, float drift = 0.0F) noexcept
        : reference_span_{reference_span}, drift_{drift} {}

    // One cycle; false when either is not finite.
    bool is_stuck(float value, float reference) noexcept;

    // The value has changed in the last cycle, for any motion of the reference.
    bool moves() const noexcept { return value_.moves(); }

    // It has not moved for longer than the noise of a living sensor allows; no proof by itself.
    bool seems_frozen() const noexcept { return repetitions_ >= suspicious_repetitions; }

 private:
    static constexpr std::uint32_t fewest_repetitions = 20U;
    static constexpr std::uint32_t suspicious_repetitions = 5U;
    static constexpr std::uint32_t without_drift = 100U;
    static constexpr std::uint32_t most_repetitions = 1'000'000U;  // a float has a number for each

    float reference_span_;
    float drift_;
    Repetition value_{};
    float lowest_{rsi::not_available};
    float highest_{rsi::not_available};
    std::uint32_t repetitions_{0U};
};

}  // namespace rsi::monitoring
