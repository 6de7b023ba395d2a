// Sensor noise: has a signal shown any?
#pragma once

#include <cstdint>

#include "rsi/numeric/saturating_count.hpp"

namespace rsi::monitoring {

// A signal that moves smoothly, as an ideal or a filtered one, may as well stand still. Only noise turns it
// back from one sample to the next, again and again within a short time. Values that are held for several
// samples never do.
class SensorNoise {
 public:
    // One sample; one that is not finite is none.
    void update(float value) noexcept {
        if (turns_ >= enough_turns) {
            return;
        }
        const float change = value - value_;
        const bool turns = change * change_ < 0.0F;
        if (turns) {
            samples_ = 0U;
            turns_ += 1U;
        } else {
            rsi::count_up(samples_);
            turns_ = (samples_ > longest_between) ? 0U : turns_;
        }
        value_ = value;
        change_ = change;
    }

    bool is_known() const noexcept { return turns_ >= enough_turns; }

 private:
    static constexpr std::uint32_t enough_turns = 3U;
    static constexpr std::uint32_t longest_between = 20U;  // samples from one turn to the next

    float value_{0.0F};
    float change_{0.0F};
    std::uint32_t turns_{0U};
    std::uint32_t samples_{0U};
};

}  // namespace rsi::monitoring
