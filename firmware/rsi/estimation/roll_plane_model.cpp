#include "rsi/estimation/roll_plane_model.hpp"

#include "rsi/numeric/bounded_functions.hpp"

namespace rsi {
namespace {

constexpr float largest_model_angle_rad = 0.5F;

float within_model(float angle_rad) {
    return clamp_magnitude(angle_rad, largest_model_angle_rad);
}

}  // namespace

void RollPlaneModel::init(const Parameters& parameters) {
    stiffness_nmprad_ = parameters.roll_stiffness_nmprad;
    damping_nmsprad_ = parameters.roll_damping_nmsprad;
    damping_inverse_ = 1.0F / damping_nmsprad_;
    angle_to_rate_per_s_ = stiffness_nmprad_ * damping_inverse_;
    spring_step_s_ = sample_time_s / (1.0F + 0.5F * sample_time_s * angle_to_rate_per_s_);
    assume_body(calibrated_body(parameters));
}

void RollPlaneModel::assume_body(const SprungBody& body) {
    sprung_mass_kg_ = body.mass_kg;
    moment_arm_m_ = body.roll_arm_m;
    force_to_rate_ = sprung_mass_kg_ * moment_arm_m_ * damping_inverse_;
    // Positive: K_f >= 1.2 m_s g H is validated, and no load is assumed that K_f does not hold.
    const float gravity_per_s = force_to_rate_ * gravity_mps2;
    upright_step_s_ = sample_time_s / (1.0F + 0.5F * sample_time_s * (angle_to_rate_per_s_ - gravity_per_s));
}

float RollPlaneModel::roll_rate_radps(float angle_rad, float tan_gravity_angle,
                                      const Measurement& measurement, float additional_roll_moment_nm) const {
    const float force_mps2 =
        measurement.road_parallel_force_mps2 + measurement.road_normal_force_mps2 * tan_gravity_angle;
    return force_to_rate_ * force_mps2 + additional_roll_moment_nm * damping_inverse_ -
           angle_to_rate_per_s_ * angle_rad;
}

float RollPlaneModel::next_upright_angle_rad(float angle_rad, float rate_radps) const {
    return within_model(angle_rad + upright_step_s_ * rate_radps);
}

float RollPlaneModel::next_spring_angle_rad(float angle_rad, float rate_radps) const {
    return within_model(angle_rad + spring_step_s_ * rate_radps);
}

void FixedModelRoll::reset(float angle_rad) {
    angle_rad_ = within_model(angle_rad);
    tan_angle_ = short_range_tangent(angle_rad_);
    moving_ = false;
}

void FixedModelRoll::update(const RollPlaneModel& model, const Measurement& measurement) {
    if (moving_) {
        const float rate_radps = model.roll_rate_radps(angle_rad_, tan_angle_, measurement, 0.0F);
        angle_rad_ = model.next_upright_angle_rad(angle_rad_, 0.5F * (rate_radps_ + rate_radps));
        tan_angle_ = short_range_tangent(angle_rad_);
    }
    moving_ = true;
    rate_radps_ = model.roll_rate_radps(angle_rad_, tan_angle_, measurement, 0.0F);
}

void CompensatedModelRoll::reset(float angle_rad) {
    angle_rad_ = within_model(angle_rad);
    moving_ = false;
}

void CompensatedModelRoll::update(const RollPlaneModel& model, const Measurement& measurement,
                                  const FixedModelRoll& fixed, float additional_roll_moment_nm) {
    const float tan_angle = fixed.tan_angle();
    if (moving_) {
        const float rate_radps =
            model.roll_rate_radps(angle_rad_, tan_angle, measurement, additional_roll_moment_nm);
        angle_rad_ = model.next_spring_angle_rad(angle_rad_, 0.5F * (rate_radps_ + rate_radps));
    }
    moving_ = true;
    rate_radps_ = model.roll_rate_radps(angle_rad_, tan_angle, measurement, additional_roll_moment_nm);
}

}  // namespace rsi
