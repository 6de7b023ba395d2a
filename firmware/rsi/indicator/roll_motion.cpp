#include "rsi/indicator/roll_motion.hpp"

namespace rsi {

void RollMotionFilter::init(const Parameters& parameters) {
    weight_ = lag_weight(parameters.prediction_filter_lag_s);
}

void RollMotionFilter::reset(const Measurement& measured) {
    parallel_force_.reset(measured.road_parallel_force_mps2);
    normal_force_.reset(measured.road_normal_force_mps2);
    lateral_acceleration_.reset(measured.lateral_acceleration_mps2);
    roll_angle_.reset(measured.roll_angle_rad);
    roll_rate_.reset(measured.roll_rate_radps);
    parallel_force_rate_mps3_ = 0.0F;
    roll_acceleration_radps2_ = 0.0F;
}

RollMotion RollMotionFilter::update(const Measurement& measured) {
    parallel_force_.update(measured.road_parallel_force_mps2, weight_);
    normal_force_.update(measured.road_normal_force_mps2, weight_);
    lateral_acceleration_.update(measured.lateral_acceleration_mps2, weight_);
    roll_angle_.update(measured.roll_angle_rad, weight_);
    roll_rate_.update(measured.roll_rate_radps, weight_);
    parallel_force_rate_mps3_ += weight_ * (parallel_force_.derivative() - parallel_force_rate_mps3_);

    roll_acceleration_radps2_ += weight_ * (roll_rate_.derivative() - roll_acceleration_radps2_);

    RollMotion motion;
    motion.road_parallel_force_mps2 = parallel_force_.value();
    motion.road_normal_force_mps2 = larger(normal_force_.value(), 0.1F * gravity_mps2);
    motion.lateral_acceleration_mps2 = lateral_acceleration_.value();
    motion.roll_angle_rad = roll_angle_.value();
    motion.roll_rate_radps = roll_rate_.value();
    motion.roll_acceleration_radps2 = roll_acceleration_radps2_;
    motion.road_parallel_force_rate_mps3 = parallel_force_rate_mps3_;
    return motion;
}

}  // namespace rsi
