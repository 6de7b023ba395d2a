// Stuck check: detects a constant signal while a reference signal shows motion.
#pragma once

#include <cstdint>

#include "rsi/ecu/monitoring/repetition.hpp"
#include "rsi/numeric/bounded.hpp"

namespace rsi::monitoring {

class StuckCheck {
 public:
    // `reference_span`: least movement of the reference, in its unit, while the value is constant. `drift`:
    // increase of that for each cycle beyond the first second, for a reference that drifts by itself (an
    // integral).
    constexpr explicit StuckCheck(float reference_span, float drift = 0.0F) noexcept
        : reference_span_{reference_span}, drift_{drift} {}

    // One cycle; false, and restarted, when either is not finite.
    bool is_stuck(float value, float reference) noexcept;

    // The value has changed in the last cycle, whatever the reference did.
    bool moves() const noexcept { return value_.moves(); }

    // Constant for longer than a noisy sensor would be; supports an isolation, but is no proof by itself.
    bool seems_frozen() const noexcept { return repetitions_ >= suspicious_repetitions; }

 private:
    static constexpr std::uint32_t fewest_repetitions = 20U;
    static constexpr std::uint32_t suspicious_repetitions = 5U;
    static constexpr std::uint32_t without_drift = 100U;           // cycles
    static constexpr std::uint32_t most_repetitions = 1'000'000U;  // exactly representable as float

    float reference_span_;
    float drift_;
    Repetition value_{};
    float lowest_{rsi::not_available};
    float highest_{rsi::not_available};
    std::uint32_t repetitions_{0U};
};

}  // namespace rsi::monitoring
