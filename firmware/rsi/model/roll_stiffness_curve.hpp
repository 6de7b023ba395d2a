// Roll stiffness curve: the suspension's roll moment over the roll angle.
#pragma once

#include "rsi/types.hpp"

namespace rsi {

// M(phi) = K_f phi + K_2 phi^3 + K_4 phi^5; constant after init.
class RollStiffnessCurve {
 public:
    // `factor`: what the curve is multiplied by, 1 / Ixx for instance.
    void init(const Parameters& parameters, float factor = 1.0F) {
        linear_ = factor * parameters.roll_stiffness_nmprad;
        cubic_ = factor * parameters.roll_stiffness_cubic_nmprad3;
        quintic_ = factor * parameters.roll_stiffness_quintic_nmprad5;
    }

    float moment_nm(float angle_rad) const {
        const float z = angle_rad * angle_rad;
        return angle_rad * (linear_ + z * (cubic_ + z * quintic_));
    }

    // M(phi) / phi - K_f
    float secant_deviation_nmprad(float angle_rad) const {
        const float z = angle_rad * angle_rad;
        return z * (cubic_ + z * quintic_);
    }

    // dM/dphi
    float slope_nmprad(float angle_rad) const {
        const float z = angle_rad * angle_rad;
        return linear_ + z * (3.0F * cubic_ + z * (5.0F * quintic_));
    }

 private:
    float linear_{1.0F};
    float cubic_{0.0F};
    float quintic_{0.0F};
};

}  // namespace rsi
