#include "rsi/estimation/roll_plane_model.hpp"

#include "rsi/numeric/bounded_functions.hpp"

namespace rsi {
namespace {

constexpr float largest_model_angle_rad = 0.5F;

float within_model(float angle_rad) {
    return clamp_magnitude(angle_rad, largest_model_angle_rad);
}

// phi' at `angle_rad`; `tan_gravity_angle` is the tangent in the gravity term.
float roll_rate_radps(const Vehicle& vehicle, float angle_rad, float tan_gravity_angle,
                      const Measurement& measurement, float additional_roll_moment_nm) {
    const float force_mps2 =
        measurement.road_parallel_force_mps2 + measurement.road_normal_force_mps2 * tan_gravity_angle;
    return vehicle.loaded.force_to_rate * force_mps2 +
           additional_roll_moment_nm * vehicle.suspension.damping_inverse -
           vehicle.suspension.angle_to_rate_per_s * angle_rad;
}

}  // namespace

void FixedModelRoll::reset(float angle_rad) {
    angle_rad_ = within_model(angle_rad);
    tan_angle_ = short_range_tangent(angle_rad_);
    moving_ = false;
}

void FixedModelRoll::update(const Vehicle& vehicle, const Measurement& measurement) {
    if (moving_) {
        const float rate_now_radps = roll_rate_radps(vehicle, angle_rad_, tan_angle_, measurement, 0.0F);
        angle_rad_ = within_model(angle_rad_ +
                                  vehicle.loaded.upright_step_s * (0.5F * (rate_radps_ + rate_now_radps)));
        tan_angle_ = short_range_tangent(angle_rad_);
    }
    moving_ = true;
    rate_radps_ = roll_rate_radps(vehicle, angle_rad_, tan_angle_, measurement, 0.0F);
}

void CompensatedModelRoll::reset(float angle_rad) {
    angle_rad_ = within_model(angle_rad);
    moving_ = false;
}

void CompensatedModelRoll::update(const Vehicle& vehicle, const Measurement& measurement,
                                  const FixedModelRoll& fixed, float additional_roll_moment_nm) {
    const float tan_angle = fixed.tan_angle();
    if (moving_) {
        const float rate_now_radps =
            roll_rate_radps(vehicle, angle_rad_, tan_angle, measurement, additional_roll_moment_nm);
        angle_rad_ = within_model(angle_rad_ +
                                  vehicle.suspension.spring_step_s * (0.5F * (rate_radps_ + rate_now_radps)));
    }
    moving_ = true;
    rate_radps_ = roll_rate_radps(vehicle, angle_rad_, tan_angle, measurement, additional_roll_moment_nm);
}

}  // namespace rsi
