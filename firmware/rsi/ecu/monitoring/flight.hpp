// Flight: all wheels are in the air, or have just come down.
#pragma once

#include <cstdint>

#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/saturating_count.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// In the air no wheel pushes, and neither accelerometer shows a force; the landing takes the fall's speed
// back within some tenths of a second. Meanwhile the vertical one is neither judged nor used. One that has
// failed at zero looks the same on a straight, until it has taken longer than any jump or the vehicle turns.
class Flight {
 public:
    // One sample; a force that is not finite is none of a flight.
    void update(float vertical_force_mps2, float lateral_force_mps2) noexcept {
        if (vertical_force_mps2 > 0.5F * rsi::gravity_mps2) {
            rsi::count_up(calm_samples_);
        } else {
            calm_samples_ = 0U;
        }
        if (calm_samples_ >= enough_calm) {
            excused_samples_ = 0U;
        }
        samples_left_ = (excused_samples_ < most_excused) ? samples_left_ : 0U;
        excused_samples_ += (samples_left_ > 0U) ? 1U : 0U;
        if (!rsi::is_within_magnitude(vertical_force_mps2, weightless_mps2)) {
            in_air_samples_ = 0U;
            samples_left_ -= (samples_left_ > 0U) ? 1U : 0U;
            return;
        }
        if ((in_air_samples_ >= longest_flight) ||
            !rsi::is_within_magnitude(lateral_force_mps2, weightless_mps2)) {
            samples_left_ = 0U;
            return;
        }
        in_air_samples_ += 1U;
        const bool flies = (in_air_samples_ >= shortest_flight) && (excused_samples_ < most_excused);
        samples_left_ = flies ? landing_samples : samples_left_;
    }

    bool excuses() const noexcept { return samples_left_ > 0U; }

 private:
    static constexpr float weightless_mps2 = 1.5F;
    static constexpr std::uint32_t shortest_flight = 5U;  // a wheel that drops into a hole is none
    static constexpr std::uint32_t longest_flight = 100U;
    static constexpr std::uint32_t landing_samples = 100U;
    // Several in a row, as over a rough road; then it must have carried the vehicle for as long as this.
    static constexpr std::uint32_t most_excused = 400U;
    static constexpr std::uint32_t enough_calm = 30U;

    std::uint32_t in_air_samples_{0U};
    std::uint32_t samples_left_{0U};
    std::uint32_t calm_samples_{0U};
    std::uint32_t excused_samples_{0U};
};

}  // namespace rsi::monitoring
