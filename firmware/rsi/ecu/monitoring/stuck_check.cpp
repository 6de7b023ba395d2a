#include "rsi/ecu/monitoring/stuck_check.hpp"

namespace rsi::monitoring {

bool StuckCheck::is_stuck(float value, float witness) noexcept {
    if (!value_.repeats(value) || !rsi::is_finite(witness)) {
        repetitions_ = 0U;
        lowest_ = witness;
        highest_ = witness;
        return false;
    }
    repetitions_ += (repetitions_ < most_repetitions) ? 1U : 0U;
    lowest_ = rsi::smaller(lowest_, witness);
    highest_ = rsi::larger(highest_, witness);
    const std::uint32_t drifting = (repetitions_ > without_drift) ? repetitions_ - without_drift : 0U;
    const float least = witness_span_ + drift_ * static_cast<float>(drifting);
    return (repetitions_ >= fewest_repetitions) && ((highest_ - lowest_) > least);
}

}  // namespace rsi::monitoring
