#include "rsi/model/roll_plane_model.hpp"

namespace rsi {
namespace {

constexpr float largest_model_angle_rad = 0.5F;

float within_model(float angle_rad) {
    return clamp_magnitude(angle_rad, largest_model_angle_rad);
}

}  // namespace

void RollPlaneModel::init(const Parameters& parameters) {
    sprung_mass_kg_ = parameters.sprung_mass_kg;
    moment_arm_m_ = parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m;
    stiffness_nmprad_ = parameters.roll_stiffness_nmprad;
    damping_nmsprad_ = parameters.roll_damping_nmsprad;
}

float RollPlaneModel::roll_rate_radps(float angle_rad, float tan_gravity_angle,
                                      const Measurement& measurement, float additional_roll_moment_nm) const {
    const float force_mps2 =
        measurement.road_parallel_force_mps2 + measurement.road_normal_force_mps2 * tan_gravity_angle;
    const float moment_nm = sprung_mass_kg_ * moment_arm_m_ * force_mps2 + additional_roll_moment_nm;
    return (moment_nm - stiffness_nmprad_ * angle_rad) / damping_nmsprad_;
}

float RollPlaneModel::next_angle_rad(float angle_rad, float rate_radps, float stiffness_nmprad) const {
    const float divisor = 1.0F + 0.5F * sample_time_s * stiffness_nmprad / damping_nmsprad_;
    // A negative local stiffness (a vehicle past its static balance) must not flip the sign of the step.
    return within_model(angle_rad + sample_time_s * rate_radps / larger(divisor, 0.5F));
}

void FixedModelRoll::reset(float angle_rad) {
    angle_rad_ = within_model(angle_rad);
    rate_radps_ = 0.0F;
    tan_angle_ = bounded_tangent(angle_rad_);
}

void FixedModelRoll::evaluate(const RollPlaneModel& model, const Measurement& measurement) {
    tan_angle_ = bounded_tangent(angle_rad_);
    rate_radps_ = model.roll_rate_radps(angle_rad_, tan_angle_, measurement, 0.0F);
}

void FixedModelRoll::advance(const RollPlaneModel& model, const Measurement& measurement) {
    const float secant_squared = 1.0F + tan_angle_ * tan_angle_;
    const float gravity_stiffness =
        model.sprung_mass_kg() * measurement.road_normal_force_mps2 * model.moment_arm_m() * secant_squared;
    angle_rad_ = model.next_angle_rad(angle_rad_, rate_radps_, model.stiffness_nmprad() - gravity_stiffness);
}

void CompensatedModelRoll::reset(float angle_rad) {
    angle_rad_ = within_model(angle_rad);
}

void CompensatedModelRoll::advance(const RollPlaneModel& model, const Measurement& measurement,
                                   const FixedModelRoll& fixed, float additional_roll_moment_nm) {
    const float rate_radps =
        model.roll_rate_radps(angle_rad_, fixed.tan_angle(), measurement, additional_roll_moment_nm);
    angle_rad_ = model.next_angle_rad(angle_rad_, rate_radps, model.stiffness_nmprad());
}

}  // namespace rsi
