#include "rsi/indicator/stability_threshold.hpp"

namespace rsi {
namespace {

constexpr float smallest_half_track_ratio = 0.05F;
// Where a bank brings a_y* near zero or past it, (25) has no meaning; the threshold stays at least this far
// out.
constexpr float smallest_threshold_mps2 = 0.05F * gravity_mps2;
// A bank so favourable that no lateral acceleration lifts the inner wheels: the divisor goes to zero.
constexpr float smallest_divisor = 0.05F;

}  // namespace

void StabilityThresholdStage::init(const Parameters& parameters) {
    half_track_m_ = 0.5F * parameters.track_width_m;
    cg_height_m_ = parameters.sprung_cg_height_m;
    fixed_roll_centre_height_m_ = parameters.fixed_roll_centre_height_m;
}

StabilityThreshold StabilityThresholdStage::evaluate(const Measurement& measured, float vertical_movement_m,
                                                     float lateral_movement_m) const {
    const float s = (measured.road_parallel_force_mps2 < 0.0F) ? -1.0F : 1.0F;
    const float h_rc = fixed_roll_centre_height_m_ + vertical_movement_m;
    const float shift_m = lateral_movement_m + (cg_height_m_ - h_rc) * measured.tan_roll_angle;
    const float T = larger((half_track_m_ - s * shift_m) / cg_height_m_, smallest_half_track_ratio);
    const float e = -s * bounded_tangent(measured.bank_angle_rad);
    const float magnitude_mps2 = gravity_mps2 * (e + T) / larger(1.0F - e * T, smallest_divisor);

    StabilityThreshold threshold;
    threshold.side = s;
    threshold.half_track_ratio = T;
    threshold.lateral_acceleration_mps2 = s * larger(magnitude_mps2, smallest_threshold_mps2);
    threshold.is_defined = (magnitude_mps2 >= smallest_threshold_mps2);
    return threshold;
}

}  // namespace rsi
