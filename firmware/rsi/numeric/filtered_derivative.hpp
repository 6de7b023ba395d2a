// Derivative of a sampled signal through a first-order lag.
#pragma once

#include "rsi/numeric/two_lags.hpp"
#include "rsi/types.hpp"

namespace rsi {

// Weights that follow from the time of the lag, `lag_s` >= 0; 0 gives the plain difference quotient.
struct DerivativeLag {
    DerivativeLag() = default;
    explicit constexpr DerivativeLag(float lag_s)
        : weight(lag_weight(lag_s)), gain_per_s(weight / sample_time_s) {}

    float weight{};
    float gain_per_s{};
};

// The value less its first-order lag, over the lag's time: the same as the difference quotient through the
// lag.
class FilteredDerivative {
 public:
    void reset() { running_ = false; }

    // Unit of the value per second; 0 on the first value after a reset.
    float update(const DerivativeLag& lag, float value) {
        if (!running_) {
            lagged_ = value;
            running_ = true;
        }
        const float change = value - lagged_;
        lagged_ += lag.weight * change;
        return lag.gain_per_s * change;
    }

 private:
    float lagged_{};
    bool running_{false};
};

}  // namespace rsi
