// Derivative of a sampled signal through a first-order lag.
#pragma once

#include "rsi/numeric/two_lags.hpp"
#include "rsi/types.hpp"

namespace rsi {

// The value less its first-order lag, over the lag's time: the same as the difference quotient through the
// lag.
class FilteredDerivative {
 public:
    // `lag_s` >= 0, from now on; 0 gives the plain difference quotient. The signal goes on.
    void tune(float lag_s) {
        weight_ = lag_weight(lag_s);
        gain_per_s_ = weight_ / sample_time_s;
    }

    void reset() { running_ = false; }

    // Unit of the value per second; 0 on the first value after a reset.
    float update(float value) {
        if (!running_) {
            lagged_ = value;
            running_ = true;
        }
        const float change = value - lagged_;
        lagged_ += weight_ * change;
        return gain_per_s_ * change;
    }

 private:
    float weight_{1.0F};
    float gain_per_s_{1.0F / sample_time_s};
    float lagged_{0.0F};
    bool running_{false};
};

}  // namespace rsi
