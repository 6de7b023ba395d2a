#include "rsi/ecu/monitoring/stuck_check.hpp"

namespace rsi::monitoring {

bool StuckCheck::is_stuck(float value, float reference) noexcept {
    if (!value_.repeats(value) || !rsi::is_finite(reference)) {
        repetitions_ = 0U;
        lowest_ = reference;
        highest_ = reference;
        return false;
    }
    repetitions_ += (repetitions_ < most_repetitions) ? 1U : 0U;
    lowest_ = rsi::smaller(lowest_, reference);
    highest_ = rsi::larger(highest_, reference);
    const std::uint32_t drifting = (repetitions_ > without_drift) ? repetitions_ - without_drift : 0U;
    const float least = reference_span_ + drift_ * static_cast<float>(drifting);
    return (repetitions_ >= fewest_repetitions) && ((highest_ - lowest_) > least);
}

}  // namespace rsi::monitoring
