#include "rsi/indicator/stability_threshold.hpp"

namespace rsi {
namespace {

constexpr float smallest_half_track_ratio = 0.05F;
// If a bank brings a_y* near zero or past it, (25) has no meaning; the threshold stays at least this far
// out.
constexpr float smallest_threshold_mps2 = 0.05F * gravity_mps2;
// A bank so favourable that no lateral acceleration lifts the inner wheels: the divisor goes to zero.
constexpr float smallest_divisor = 0.05F;

}  // namespace

StabilityThreshold stability_threshold(const Vehicle& vehicle, const Measurement& measured,
                                       float vertical_movement_m, float lateral_movement_m) {
    const float s = (measured.road_parallel_force_mps2 >= 0.0F) ? 1.0F : -1.0F;
    const float H = vehicle.loaded.body.roll_arm_m - vertical_movement_m;
    const float shift_m = lateral_movement_m + H * measured.tan_roll_angle;
    const float T = larger((vehicle.suspension.half_track_m - s * shift_m) * vehicle.loaded.cg_height_inverse,
                           smallest_half_track_ratio);
    const float s_tan_bank = s * measured.tan_bank_angle;
    const float magnitude_mps2 =
        gravity_mps2 * (T - s_tan_bank) / larger(1.0F + s_tan_bank * T, smallest_divisor);

    StabilityThreshold threshold;
    threshold.side = s;
    threshold.half_track_ratio = T;
    threshold.is_defined = (magnitude_mps2 >= smallest_threshold_mps2);
    threshold.lateral_acceleration_mps2 =
        s * (threshold.is_defined ? magnitude_mps2 : smallest_threshold_mps2);
    return threshold;
}

}  // namespace rsi
