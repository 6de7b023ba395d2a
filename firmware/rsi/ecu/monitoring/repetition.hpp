// Repetition: detects a sample that equals the one before, exactly: a working sensor has noise, a frozen one
// repeats its raw value.
#pragma once

#include "rsi/numeric/bounded.hpp"

namespace rsi::monitoring {

class Repetition {
 public:
    // One sample; true when it is finite and equals the previous one.
    bool repeats(float value) noexcept {
        const bool repeated = (value <= value_) && (value >= value_);
        moves_ = !repeated && rsi::is_finite(value - value_);
        value_ = value;
        return repeated && rsi::is_finite(value);
    }

    // The last two samples are finite and differ.
    bool moves() const noexcept { return moves_; }

 private:
    float value_{rsi::not_available};
    bool moves_{false};
};

}  // namespace rsi::monitoring
