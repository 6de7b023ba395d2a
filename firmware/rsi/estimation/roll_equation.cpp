#include "rsi/estimation/roll_equation.hpp"

#include "rsi/numeric/two_lags.hpp"

namespace rsi {

void FilteredRollEquation::init(const Parameters& parameters) {
    curve_.init(parameters);
    sprung_mass_kg_ = parameters.sprung_mass_kg;
    moment_arm_m_ = parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m;
    damping_nmsprad_ = parameters.roll_damping_nmsprad;
    inertia_kgm2_ = parameters.roll_inertia_kgm2;
    const float lag_s = parameters.estimator_filter_lag_s;
    weight_ = lag_weight(lag_s);
    // After eight time constants two equal lags still hold 0.3 % of what they were started with.
    settling_samples_ = 2 + static_cast<int>(8.0F * lag_s / sample_time_s);
    restart();
}

FilteredRollEquation::Passed FilteredRollEquation::pass(Signal& signal, float value) const {
    const float before = signal.second;
    signal.first += weight_ * (value - signal.first);
    signal.second += weight_ * (signal.first - signal.second);
    return Passed{0.5F * (signal.second + before), signal.second - before};
}

RollEquation FilteredRollEquation::update(const Measurement& measured) {
    const float force_n = sprung_mass_kg_ * (measured.road_parallel_force_mps2 +
                                             measured.road_normal_force_mps2 * measured.tan_roll_angle);
    RollEquation equation;
    equation.stiffness_moment_nm = curve_.moment_nm(measured.roll_angle_rad);
    equation.stiffness_deviation_nmprad = curve_.secant_deviation_nmprad(measured.roll_angle_rad);
    const float moment_nm =
        moment_arm_m_ * force_n - equation.stiffness_moment_nm - damping_nmsprad_ * measured.roll_rate_radps;
    if (samples_ == 0) {
        moment_ = Signal{moment_nm, moment_nm};
        force_ = Signal{force_n, force_n};
        rate_ = Signal{measured.roll_rate_radps, measured.roll_rate_radps};
    }
    const Passed rate = pass(rate_, measured.roll_rate_radps);
    equation.roll_rate_radps = rate.mean;
    equation.roll_acceleration_radps2 = rate.change * (1.0F / sample_time_s);
    equation.lateral_force_n = pass(force_, force_n).mean;
    equation.residual_nm = pass(moment_, moment_nm).mean - inertia_kgm2_ * equation.roll_acceleration_radps2;
    equation.settled = (samples_ >= settling_samples_);
    samples_ += equation.settled ? 0 : 1;
    return equation;
}

}  // namespace rsi
