// Repetition: whether a signal says the very same again. The equality of floats is meant: a sensor that lives
// has noise, and a frozen one repeats its code.
#pragma once

#include "rsi/numeric/bounded.hpp"

namespace rsi::monitoring {

class Repetition {
 public:
    // One sample: true when it is the one before; never of one that is not finite.
    bool repeats(float value) noexcept {
        const bool repeated = (value <= value_) && (value >= value_);
        moves_ = !repeated && rsi::is_finite(value - value_);
        value_ = value;
        return repeated && rsi::is_finite(value);
    }

    // The latest sample is another one than the one before, and both are finite.
    bool moves() const noexcept { return moves_; }

 private:
    float value_{rsi::not_available};
    bool moves_{false};
};

}  // namespace rsi::monitoring
