#include "rsi/estimation/roll_equation.hpp"

namespace rsi {

FilteredRollEquation::Constants::Constants(const Parameters& parameters)
    : weight(lag_weight(parameters.estimator_filter_lag_s)),
      // After eight time constants two equal lags still hold 0.3 % of what they were started with.
      settling_samples(2 + static_cast<int>(8.0F * parameters.estimator_filter_lag_s / sample_time_s)) {}

RollEquation FilteredRollEquation::update(const Constants& constants, const Vehicle& vehicle,
                                          const Measurement& measured) {
    const SprungBody& body = vehicle.loaded.body;
    const RollStiffnessCurve& springs = vehicle.suspension.springs;
    const float weight = constants.weight;
    const float force_n = body.mass_kg * (measured.road_parallel_force_mps2 +
                                          measured.road_normal_force_mps2 * measured.tan_roll_angle);
    RollEquation equation;
    equation.stiffness_deviation_nmprad = springs.secant_deviation_nmprad(measured.roll_angle_rad);
    equation.stiffness_moment_nm = springs.moment_nm(measured.roll_angle_rad);
    const float moment_nm = body.roll_arm_m * force_n - equation.stiffness_moment_nm -
                            vehicle.suspension.damping_nmsprad * measured.roll_rate_radps;
    if (samples_ == 0) {
        moment_.reset(moment_nm);
        force_.reset(force_n);
        rate_.reset(measured.roll_rate_radps);
    }
    const float rate_change = rate_.update(measured.roll_rate_radps, weight);
    const float force_change = force_.update(force_n, weight);
    const float moment_change = moment_.update(moment_nm, weight);
    equation.roll_rate_radps = rate_.value() - 0.5F * rate_change;
    equation.roll_acceleration_radps2 = rate_change * (1.0F / sample_time_s);
    equation.lateral_force_n = force_.value() - 0.5F * force_change;
    equation.inertia_moment_nm = body.roll_inertia_kgm2 * equation.roll_acceleration_radps2;
    equation.residual_nm = moment_.value() - 0.5F * moment_change - equation.inertia_moment_nm;
    equation.settled = (samples_ >= constants.settling_samples);
    samples_ += equation.settled ? 0 : 1;
    return equation;
}

}  // namespace rsi
