// Two equal first-order lags in a row, with the change of what comes out.
#pragma once

#include "rsi/numeric/bounded_functions.hpp"
#include "rsi/types.hpp"

namespace rsi {

// The share of a new value in a first-order lag's next output. `lag_s` >= 0; 0 passes the value through.
constexpr float lag_weight(float lag_s) {
    return (lag_s > 0.0F) ? 1.0F - decaying_exponential(sample_time_s / lag_s) : 1.0F;
}

class TwoLags {
 public:
    // As if `value` had always been there.
    void reset(float value) {
        first_ = value;
        second_ = value;
    }

    // Takes the next value in; returns by how much what comes out has changed. `weight` as lag_weight() gives
    // it.
    float update(float value, float weight) {
        first_ += weight * (value - first_);
        const float change = weight * (first_ - second_);
        second_ += change;
        return change;
    }

    float value() const { return second_; }

 private:
    float first_{0.0F};
    float second_{0.0F};
};

}  // namespace rsi
