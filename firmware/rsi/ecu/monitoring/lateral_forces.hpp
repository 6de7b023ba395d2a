// Lateral forces: the same force along the road as three sensors have it.
#pragma once

namespace rsi::monitoring {

// Specific forces at the centre of gravity, at one and the same delay: by the accelerometer, and what it will
// show in 80 ms, which is the force of now if it is as late as a good one may be; yaw rate times speed, which
// lacks what the road's bank adds; and the force that rolls the body as it rolls, which a load makes larger.
struct LateralForces {
    float shown_mps2{0.0F};
    float shown_soon_mps2{0.0F};
    float by_yaw_mps2{0.0F};
    float by_roll_mps2{0.0F};
};

}  // namespace rsi::monitoring
