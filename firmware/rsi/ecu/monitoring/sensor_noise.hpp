// Sensor noise: has a signal shown any?
#pragma once

#include <cstdint>

namespace rsi::monitoring {

// A signal that moves smoothly, as an ideal or a filtered one, may as well stand still. Only noise turns it
// back from one sample to the next, again and again.
class SensorNoise {
 public:
    // One sample; one that is not finite is none.
    void update(float value) noexcept {
        if (turns_ >= enough_turns) {
            return;
        }
        const float change = value - value_;
        turns_ += (change * change_ < 0.0F) ? 1U : 0U;
        value_ = value;
        change_ = change;
    }

    bool is_known() const noexcept { return turns_ >= enough_turns; }

 private:
    static constexpr std::uint32_t enough_turns = 3U;

    float value_{0.0F};
    float change_{0.0F};
    std::uint32_t turns_{0U};
};

}  // namespace rsi::monitoring
