// Roll sensor check: does the roll sensor contradict the observer?
#pragma once

#include <cstdint>

#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi {

// True after the two have been further apart than `observer_disagreement_rad` for longer than
// `observer_disagreement_s`; false again after they have been closer than half of it for as long.
class RollSensorCheck {
 public:
    [[gnu::cold]] void tune(const Parameters& parameters) {
        limit_rad_ = parameters.observer_disagreement_rad;
        confirmation_samples_ =
            static_cast<std::int32_t>(parameters.observer_disagreement_s / sample_time_s + 0.5F);
    }

    void reset() {
        disagrees_ = false;
        samples_ = 0;
    }

    // One sample. `difference_rad`: sensor minus observer.
    void update(float difference_rad) {
        const float distance_rad = absolute(difference_rad);
        const bool contradicts =
            disagrees_ ? (distance_rad < 0.5F * limit_rad_) : (distance_rad > limit_rad_);
        if (!contradicts) {
            samples_ = 0;
            return;
        }
        ++samples_;
        if (samples_ > confirmation_samples_) {
            disagrees_ = !disagrees_;
            samples_ = 0;
        }
    }

    bool disagrees() const { return disagrees_; }

 private:
    float limit_rad_{0.0F};
    std::int32_t confirmation_samples_{0};
    std::int32_t samples_{0};
    bool disagrees_{false};
};

}  // namespace rsi
