// Values of firmware/calibrations/large_suv.toml.
#include "images/zynqmp_r5/parameters.hpp"

namespace image {
namespace {

constexpr rsi::Parameters large_suv() {
    rsi::Parameters values{};
    values.sprung_mass_kg = 2060.0F;
    values.sprung_cg_height_m = 0.988F;
    values.track_width_m = 1.6F;
    values.roll_inertia_kgm2 = 950.0F;
    values.unsprung_mass_kg = 314.0F;
    values.unsprung_cg_height_m = 0.395F;
    values.fixed_roll_centre_height_m = 0.281F;
    values.roll_stiffness_nmprad = 96000.0F;
    values.roll_damping_nmsprad = 8000.0F;
    values.roll_stiffness_cubic_nmprad3 = 171000.0F;
    values.roll_stiffness_quintic_nmprad5 = 70900000.0F;
    values.wheelbase_m = 2.95F;
    values.steering_ratio = 20.0F;
    values.understeer_gradient_s2pm = 0.0012F;
    values.largest_lateral_acceleration_mps2 = 10.8F;
    values.imu_x_m = 0.2F;
    values.imu_y_m = 0.0F;
    values.imu_z_m = -0.35F;
    values.angular_acceleration_lag_s = 0.02F;
    values.estimator = RSI_ESTIMATOR_CONSIDER_KALMAN;
    values.forgetting_factor = 0.999F;
    values.disturbance_cutoff_hz = 0.1F;
    values.regression_scale_nm = 450.0F;
    values.initial_roll_centre_deviation_m = 0.1F;
    values.initial_stiffness_deviation_nmprad = 10000.0F;
    values.initial_damping_deviation_nmsprad = 1000.0F;
    values.covariance_limit = 300.0F;
    values.roll_centre_prior_deviation_m = 0.08F;
    values.roll_centre_limit_m = 0.25F;
    values.roll_centre_reversion_s = 1.0F;
    values.estimator_filter_lag_s = 0.04F;
    values.excitation_threshold_mps2 = 1.5F;
    values.freeze_level = 0.9F;
    values.load_transfer_inertial_weight = 0.45F;
    values.prediction_horizon_s = 0.11F;
    values.acceleration_trend_s = 0.2F;
    values.prediction_filter_lag_s = 0.02F;
    values.rollover_index_angle_weight = 0.4F;
    values.rollover_index_acceleration_weight = 0.4F;
    values.rollover_index_slope_radps = -5.0F;
    values.rollover_index_roll_angle_rad = 0.12F;
    values.rollover_index_roll_rate_radps = 0.8F;
    values.rollover_index_acceleration_mps2 = 7.0F;
    values.time_to_rollover_limit_s = 0.5F;
    values.observer_bank_drift_radps = 0.02F;
    values.observer_disagreement_rad = 0.05F;
    values.observer_disagreement_s = 0.3F;
    values.warning_indicator = RSI_INDICATOR_PREDICTED_LOAD_TRANSFER;
    values.advisory_on = 0.8F;
    values.advisory_off = 0.7F;
    values.warning_on = 0.92F;
    values.warning_off = 0.8F;
    values.warning_confirmation_s = 0.02F;
    values.advisory_hold_s = 0.5F;
    values.warning_hold_s = 2.0F;
    values.recovery_s = 0.1F;
    return values;
}

}  // namespace

[[gnu::section(".parameters")]] extern const rsi::Parameters parameters = large_suv();

}  // namespace image
