#include "rsi/measurement/roll_motion.hpp"

namespace rsi {

void RollMotionFilter::reset(const Measurement& measured) {
    parallel_force_.reset(measured.road_parallel_force_mps2);
    normal_force_.reset(measured.road_normal_force_mps2);
    roll_angle_.reset(measured.roll_angle_rad);
    roll_rate_.reset(measured.roll_rate_radps);
    parallel_force_rate_mps3_ = 0.0F;
    roll_acceleration_radps2_ = 0.0F;
}

RollMotion RollMotionFilter::update(const Constants& constants, const Measurement& measured) {
    const float weight = constants.weight;
    const float force_change = parallel_force_.update(measured.road_parallel_force_mps2, weight);
    const float rate_change = roll_rate_.update(measured.roll_rate_radps, weight);
    normal_force_.update(measured.road_normal_force_mps2, weight);
    roll_angle_.update(measured.roll_angle_rad, weight);
    parallel_force_rate_mps3_ += weight * (force_change * (1.0F / sample_time_s) - parallel_force_rate_mps3_);
    roll_acceleration_radps2_ += weight * (rate_change * (1.0F / sample_time_s) - roll_acceleration_radps2_);

    RollMotion motion;
    motion.road_parallel_force_mps2 = parallel_force_.value();
    motion.road_normal_force_mps2 = normal_force_.value();
    // The bank's share moves slowly, so it needs no lags of its own.
    motion.lateral_acceleration_mps2 =
        parallel_force_.value() - (measured.road_parallel_force_mps2 - measured.lateral_acceleration_mps2);
    motion.roll_angle_rad = clamp_magnitude(roll_angle_.value(), largest_spring_angle_rad);
    motion.roll_rate_radps = roll_rate_.value();
    motion.roll_acceleration_radps2 = roll_acceleration_radps2_;
    motion.road_parallel_force_rate_mps3 = parallel_force_rate_mps3_;
    return motion;
}

}  // namespace rsi
