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
    struct Constants {
        Constants() = default;
        [[gnu::cold]] explicit Constants(const Parameters& parameters)
            : limit_rad(parameters.observer_disagreement_rad),
              confirmation_samples(
                  static_cast<std::int32_t>(parameters.observer_disagreement_s / sample_time_s + 0.5F)) {}

        float limit_rad{};
        std::int32_t confirmation_samples{};
    };

    void reset() {
        disagrees_ = false;
        samples_ = 0;
    }

    // One sample. `difference_rad`: sensor minus observer.
    void update(const Constants& constants, float difference_rad) {
        const float distance_rad = absolute(difference_rad);
        const bool contradicts =
            disagrees_ ? (distance_rad < 0.5F * constants.limit_rad) : (distance_rad > constants.limit_rad);
        if (!contradicts) {
            samples_ = 0;
            return;
        }
        ++samples_;
        if (samples_ > constants.confirmation_samples) {
            disagrees_ = !disagrees_;
            samples_ = 0;
        }
    }

    bool disagrees() const { return disagrees_; }

 private:
    std::int32_t samples_{};
    bool disagrees_{false};
};

}  // namespace rsi
