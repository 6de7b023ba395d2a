#include "rsi/estimation/roll_equation.hpp"

namespace rsi {

void FilteredRollEquation::tune(const Parameters& parameters) {
    curve_.init(parameters);
    damping_nmsprad_ = parameters.roll_damping_nmsprad;
    assume_body(calibrated_body(parameters));
    const float lag_s = parameters.estimator_filter_lag_s;
    weight_ = lag_weight(lag_s);
    // After eight time constants two equal lags still hold 0.3 % of what they were started with.
    settling_samples_ = 2 + static_cast<int>(8.0F * lag_s / sample_time_s);
}

void FilteredRollEquation::assume_body(const SprungBody& body) {
    sprung_mass_kg_ = body.mass_kg;
    moment_arm_m_ = body.roll_arm_m;
    inertia_kgm2_ = body.roll_inertia_kgm2;
}

RollEquation FilteredRollEquation::update(const Measurement& measured) {
    const float force_n = sprung_mass_kg_ * (measured.road_parallel_force_mps2 +
                                             measured.road_normal_force_mps2 * measured.tan_roll_angle);
    RollEquation equation;
    equation.stiffness_deviation_nmprad = curve_.secant_deviation_nmprad(measured.roll_angle_rad);
    equation.stiffness_moment_nm = curve_.moment_nm(measured.roll_angle_rad);
    const float moment_nm =
        moment_arm_m_ * force_n - equation.stiffness_moment_nm - damping_nmsprad_ * measured.roll_rate_radps;
    if (samples_ == 0) {
        moment_.reset(moment_nm);
        force_.reset(force_n);
        rate_.reset(measured.roll_rate_radps);
    }
    const float rate_change = rate_.update(measured.roll_rate_radps, weight_);
    const float force_change = force_.update(force_n, weight_);
    const float moment_change = moment_.update(moment_nm, weight_);
    equation.roll_rate_radps = rate_.value() - 0.5F * rate_change;
    equation.roll_acceleration_radps2 = rate_change * (1.0F / sample_time_s);
    equation.lateral_force_n = force_.value() - 0.5F * force_change;
    equation.inertia_moment_nm = inertia_kgm2_ * equation.roll_acceleration_radps2;
    equation.residual_nm = moment_.value() - 0.5F * moment_change - equation.inertia_moment_nm;
    equation.settled = (samples_ >= settling_samples_);
    samples_ += equation.settled ? 0 : 1;
    return equation;
}

}  // namespace rsi
