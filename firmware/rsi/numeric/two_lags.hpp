// Two equal first-order lags in a row, with the derivative of what comes out.
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
        derivative_ = 0.0F;
    }

    // `weight` as lag_weight() gives it.
    void update(float value, float weight) {
        first_ += weight * (value - first_);
        const float step = weight * (first_ - second_);
        second_ += step;
        derivative_ = step * (1.0F / sample_time_s);
    }

    float value() const { return second_; }
    float derivative() const { return derivative_; }  // unit of the value per second

 private:
    float first_{0.0F};
    float second_{0.0F};
    float derivative_{0.0F};
};

}  // namespace rsi
