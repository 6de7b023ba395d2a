// Roll consistency: what the roll angle has changed by against the integral of the roll rate.
#pragma once

#include <array>
#include <cstddef>

#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// The roll angle is against the road, the roll rate against the horizon, so the road's bank enters the
// difference; so does the noise of both. Over 2,900 drawn runs of three vehicles, with noise and without,
// banked roads and bumps among them, the difference came to 2.2 deg within 0.2 s and 6.2 deg within 1 s. A
// road may twist faster: then the inclination of the body, which the lateral force shows beyond what the turn
// needs, changes as the roll rate says.
class RollConsistency {
 public:
    // One sample; an angle or a rate that is not finite starts anew. `inclination_rad`: of the body against
    // the horizon; without one the roll angle alone is compared.
    void update(float roll_angle_rad, float roll_rate_radps, float inclination_rad) noexcept;

    bool known() const noexcept { return filled_ > short_window; }
    // Within 0.2 s they have come apart by more than 3.5 deg. `may_twist`: the road can have done it.
    bool contradicts(bool may_twist) const noexcept {
        return known() && short_.contradicts(0.061F, may_twist);
    }
    // Within 1 s by more than 9 deg.
    bool has_offset(bool may_twist) const noexcept { return known() && long_.contradicts(0.157F, may_twist); }

 private:
    static constexpr std::size_t short_window = 20U;
    static constexpr std::size_t long_window = 100U;
    static constexpr float largest_turn_rad = 50.0F;  // keeps the integral's resolution

    // Beyond the integrated roll rate.
    struct Beyond {
        float roll_angle_rad{0.0F};
        float inclination_rad{0.0F};

        bool contradicts(float limit_rad, bool may_twist) const noexcept {
            const bool agrees = rsi::is_within_magnitude(roll_angle_rad, limit_rad);
            const bool inclines = rsi::is_within_magnitude(inclination_rad, limit_rad);
            const bool twists = may_twist && inclines;
            return !agrees && !twists;
        }
    };

    // Since `window` samples; 0 while there are not so many.
    Beyond change(const Beyond& now, std::size_t window) const noexcept;

    std::array<Beyond, long_window> history_{};
    std::size_t next_{0U};
    std::size_t filled_{0U};
    float turned_rad_{0.0F};
    float inclined_rad_{0.0F};  // beyond the integrated roll rate, through a lag
    Beyond short_{};
    Beyond long_{};
};

}  // namespace rsi::monitoring
