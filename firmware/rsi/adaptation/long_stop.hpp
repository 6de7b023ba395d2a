// Long stop: detects a stop that is long enough for the load to change.
#pragma once

#include <cstdint>

#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/saturating_count.hpp"
#include "rsi/types.hpp"

namespace rsi {

// A long stop is slower than 0.5 m/s for more than 60 s. An unavailable speed neither starts nor ends a stop.
class LongStop {
 public:
    // One sample. True once in each long stop, when its 60 s have passed.
    bool begins(float speed_mps) {
        if (!is_within_magnitude(speed_mps, largest_speed_mps)) {
            return false;
        }
        if (absolute(speed_mps) >= standing_mps) {
            samples_ = 0U;
            return false;
        }
        count_up(samples_);
        return samples_ == first_long_sample;
    }

    bool is_standing() const { return samples_ > 0U; }

 private:
    static constexpr float largest_speed_mps = 150.0F;
    static constexpr float standing_mps = 0.5F;
    static constexpr float long_stop_s = 60.0F;
    static constexpr std::uint32_t first_long_sample =
        1U + static_cast<std::uint32_t>(long_stop_s / sample_time_s);

    std::uint32_t samples_{0U};
};

}  // namespace rsi
