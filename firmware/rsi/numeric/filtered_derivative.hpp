// Derivative of a sampled signal through a first-order lag.
#pragma once

#include "rsi/numeric/bounded_functions.hpp"
#include "rsi/types.hpp"

namespace rsi {

class FilteredDerivative {
 public:
    // `lag_s` >= 0; 0 gives the plain difference quotient.
    void init(float lag_s) {
        const float lag = larger(lag_s, 0.0F);
        const float weight = (lag > 0.0F) ? 1.0F - decaying_exponential(sample_time_s / lag) : 1.0F;
        retained_ = 1.0F - weight;
        gain_per_s_ = weight / sample_time_s;
        reset();
    }

    void reset() {
        has_previous_ = false;
        derivative_ = 0.0F;
    }

    // Unit of the value per second; 0 on the first value after a reset.
    float update(float value) {
        if (has_previous_) {
            derivative_ = retained_ * derivative_ + gain_per_s_ * (value - previous_);
        }
        previous_ = value;
        has_previous_ = true;
        return derivative_;
    }

 private:
    float retained_{0.0F};
    float gain_per_s_{1.0F / sample_time_s};
    float previous_{0.0F};
    float derivative_{0.0F};
    bool has_previous_{false};
};

}  // namespace rsi
