#include "rsi/indicator/roll_stability_indicator.hpp"

namespace rsi {

float normalised_indicator(const Measurement& measured, const StabilityThreshold& threshold) {
    const float ratio = threshold.is_defined
                            ? measured.lateral_acceleration_mps2 / threshold.lateral_acceleration_mps2
                            : bank_free_indicator(measured, threshold);
    return clamp(ratio, 0.0F, 1.0F);
}

float bank_free_indicator(const Measurement& measured, const StabilityThreshold& threshold) {
    // Both factors of the divisor are bounded from below.
    return smaller(absolute(measured.road_parallel_force_mps2) /
                       (measured.road_normal_force_mps2 * threshold.half_track_ratio),
                   20.0F);
}

bool has_overturned(const Measurement& measured, float static_stability_factor) {
    return absolute(measured.tan_roll_angle) >= static_stability_factor;
}

}  // namespace rsi
