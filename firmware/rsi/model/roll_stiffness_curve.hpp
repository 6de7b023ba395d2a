// Roll stiffness curve: the suspension's roll moment over the roll angle.
#pragma once

#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi {

// M(phi), and dM/dphi there.
struct RollSpring {
    float moment_nm;
    float slope_nmprad;
};

// M(phi) = K_f phi + K_2 phi^3 + K_4 phi^5, as far as its slope stays above a quarter of K_f; from there on a
// straight line. The powers are fitted to what a suspension does on the road. They mean nothing where they
// fall off: a body that leans further, as after lift-off, would be pushed over by its own springs.
class RollStiffnessCurve {
 public:
    RollStiffnessCurve() = default;
    // `factor`: what the curve is multiplied by, 1 / Ixx for instance.
    [[gnu::cold]] explicit RollStiffnessCurve(const Parameters& parameters, float factor = 1.0F);

    RollSpring at(float angle_rad) const {
        const float curved_rad = clamp_magnitude(angle_rad, curved_to_rad_);
        const float z = curved_rad * curved_rad;
        const float curved_nm = curved_rad * (linear_ + z * (cubic_ + z * quintic_));
        return RollSpring{curved_nm + (angle_rad - curved_rad) * line_slope_,
                          linear_ + z * (slope_cubic_ + z * slope_quintic_)};
    }

    float moment_nm(float angle_rad) const { return at(angle_rad).moment_nm; }

    // M(phi) / phi - K_f
    float secant_deviation_nmprad(float angle_rad) const {
        if (is_within_magnitude(angle_rad, curved_to_rad_)) {
            const float z = angle_rad * angle_rad;
            return z * (cubic_ + z * quintic_);
        }
        return moment_nm(angle_rad) / angle_rad - linear_;
    }

    float slope_nmprad(float angle_rad) const { return at(angle_rad).slope_nmprad; }

 private:
    float linear_{};
    float cubic_{};
    float quintic_{};
    float slope_cubic_{};
    float slope_quintic_{};
    float curved_to_rad_{};  // positive
    float line_slope_{};
};

}  // namespace rsi
