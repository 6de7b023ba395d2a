#include "rsi/prediction/lateral_response.hpp"

#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

// Below this a turn says nothing of the tyres' limit.
constexpr float smallest_force_mps2 = 2.0F;
// Shares of the difference a sample: down within 0.6 s, back in 5 s.
constexpr float fall_weight = 3.0F * sample_time_s / 0.6F;
constexpr float return_weight = 3.0F * sample_time_s / 5.0F;

}  // namespace

LateralResponse::LateralResponse(const Parameters& parameters)
    : largest_mps2_(parameters.largest_lateral_acceleration_mps2) {
    const float w = parameters.lateral_response_frequency_radps;
    const float zeta = parameters.lateral_response_damping;
    is_known_ = (w > 0.0F);
    lead_s_ = is_known_ ? 2.0F * zeta / w : 0.0F;
    // The trapezoidal rule over half a step, which is accurate enough; its divisor is at least 1.
    const float quarter = 0.25F * step_s;
    const float spring = quarter * quarter * w * w;
    const float damper = 2.0F * quarter * zeta * w;
    const float scale = 1.0F / (1.0F + damper + spring);
    const float force_by_force = scale * (1.0F + damper - spring);
    const float force_by_rate = scale * 2.0F * quarter;
    const float rate_by_force = -scale * 2.0F * quarter * w * w;
    const float rate_by_rate = scale * (1.0F - damper - spring);
    // Twice.
    force_by_force_ = force_by_force * force_by_force + force_by_rate * rate_by_force;
    force_by_rate_ = (force_by_force + rate_by_rate) * force_by_rate;
    rate_by_force_ = (force_by_force + rate_by_rate) * rate_by_force;
    rate_by_rate_ = rate_by_force * force_by_rate + rate_by_rate * rate_by_rate;
}

bool TyreLimit::update(const LateralResponse& response, const RollMotion& motion, const DemandedForce& demand,
                       ForceTarget& target) {
    const float largest_mps2 = response.largest_mps2();
    if (!response.is_known() || !demand.is_known) {
        limit_mps2_ += return_weight * (largest_mps2 - limit_mps2_);
        return false;
    }
    const float A = motion.road_parallel_force_mps2;
    const float tended_mps2 = response.tended_mps2(motion);
    const float asked = (A < 0.0F) ? -demand.force_mps2 : demand.force_mps2;
    const float given = (A < 0.0F) ? -tended_mps2 : tended_mps2;
    const bool saturates = (absolute(A) > smallest_force_mps2) && (asked > given) && (limit_mps2_ > given);
    limit_mps2_ += saturates ? fall_weight * (larger(given, smallest_force_mps2) - limit_mps2_)
                             : return_weight * (largest_mps2 - limit_mps2_);
    target.force_mps2 = clamp_magnitude(demand.force_mps2, limit_mps2_);
    target.least_mps2 = smaller(smaller(A, target.force_mps2), 0.0F);
    target.most_mps2 = larger(larger(A, target.force_mps2), 0.0F);
    return true;
}

ForceCourse LateralResponse::after_step(const ForceCourse& from, const ForceTarget& target) const {
    const float x = from.force_mps2 - target.force_mps2;
    const float y = from.rate_mps3;
    const float force_mps2 = target.force_mps2 + force_by_force_ * x + force_by_rate_ * y;
    return ForceCourse{clamp(force_mps2, target.least_mps2, target.most_mps2),
                       rate_by_force_ * x + rate_by_rate_ * y};
}

}  // namespace rsi
