#include "monitoring/stuck_check.hpp"

namespace monitoring {

bool StuckCheck::is_stuck(float value, float witness) noexcept {
    if (!rsi::is_finite(value) || !rsi::is_finite(witness) || !repeats(value)) {
        value_ = value;
        repetitions_ = 0U;
        lowest_ = witness;
        highest_ = witness;
        return false;
    }
    repetitions_ = (repetitions_ < fewest_repetitions) ? repetitions_ + 1U : fewest_repetitions;
    lowest_ = rsi::smaller(lowest_, witness);
    highest_ = rsi::larger(highest_, witness);
    return (repetitions_ >= fewest_repetitions) && ((highest_ - lowest_) > witness_span_);
}

}  // namespace monitoring
