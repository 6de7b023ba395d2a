/* The tests' calibration: a large SUV with the IMU at the centre of gravity. C99, for C, C++ and freestanding
 * code. Values as in firmware/calibrations/large_suv.toml, but for the IMU's place and a shorter hold. */
#ifndef TESTS_SUPPORT_LARGE_SUV_H
#define TESTS_SUPPORT_LARGE_SUV_H

#include "rsi/rsi.h"

static inline rsi_parameters rsi_test_large_suv(void) {
#ifdef __cplusplus
    rsi_parameters parameters{};
#else
    rsi_parameters parameters = {0};
#endif
    parameters.sprung_mass_kg = 2060.0F;
    parameters.sprung_cg_height_m = 0.988F;
    parameters.track_width_m = 1.6F;
    parameters.fixed_roll_centre_height_m = 0.281F;
    parameters.roll_stiffness_nmprad = 96.0e3F;
    parameters.roll_damping_nmsprad = 8.0e3F;
    parameters.angular_acceleration_lag_s = 0.02F;
    parameters.forgetting_factor = 0.999F;
    parameters.disturbance_cutoff_hz = 0.1F;
    parameters.regression_scale_nm = 450.0F;
    parameters.initial_roll_centre_deviation_m = 0.1F;
    parameters.initial_stiffness_deviation_nmprad = 10.0e3F;
    parameters.initial_damping_deviation_nmsprad = 1.0e3F;
    parameters.covariance_limit = 300.0F;
    parameters.roll_inertia_kgm2 = 950.0F;
    parameters.unsprung_mass_kg = 314.0F;
    parameters.unsprung_cg_height_m = 0.395F;
    parameters.roll_stiffness_cubic_nmprad3 = 4.22e3F;
    parameters.roll_stiffness_quintic_nmprad5 = 5.46e7F;
    parameters.wheelbase_m = 2.95F;
    parameters.steering_ratio = 20.0F;
    parameters.understeer_gradient_s2pm = 0.003F;
    parameters.largest_lateral_acceleration_mps2 = 10.8F;
    parameters.lateral_response_frequency_radps = 0.0F;
    parameters.lateral_response_damping = 0.7F;
    parameters.roll_centre_prior_deviation_m = 0.08F;
    parameters.roll_centre_limit_m = 0.25F;
    parameters.roll_centre_reversion_s = 1.0F;
    parameters.estimator_filter_lag_s = 0.04F;
    parameters.excitation_threshold_mps2 = 1.5F;
    parameters.freeze_level = 0.9F;
    parameters.load_transfer_inertial_weight = 0.0F;
    parameters.prediction_horizon_s = 0.2F;
    parameters.acceleration_trend_s = 0.15F;
    parameters.response_horizon_s = 0.3F;
    parameters.response_margin_per_s = 0.85F;
    parameters.forecast_share = 0.0F;
    parameters.forecast_limit = 0.4F;
    parameters.prediction_filter_lag_s = 0.02F;
    parameters.load_adaptation = 0.0F;
    parameters.load_margin = 0.0F;
    parameters.rollover_index_angle_weight = 0.4F;
    parameters.rollover_index_acceleration_weight = 0.4F;
    parameters.rollover_index_slope_radps = -5.0F;
    parameters.rollover_index_roll_angle_rad = 0.12F;
    parameters.rollover_index_roll_rate_radps = 0.8F;
    parameters.rollover_index_acceleration_mps2 = 7.0F;
    parameters.time_to_rollover_limit_s = 0.5F;
    parameters.observer_bank_drift_radps = 0.02F;
    parameters.observer_disagreement_rad = 0.05F;
    parameters.observer_disagreement_s = 0.3F;
    parameters.observer_margin = 0.05F;
    parameters.advisory_on = 0.9F;
    parameters.advisory_off = 0.8F;
    parameters.warning_on = 1.0F;
    parameters.warning_off = 0.9F;
    parameters.warning_confirmation_s = 0.02F;
    parameters.advisory_hold_s = 0.5F;
    parameters.warning_hold_s = 1.0F;
    parameters.recovery_s = 0.1F;
    parameters.accelerometer_noise_mps2 = 0.0F;
    parameters.speed_resolution_mps = 0.01F;
    parameters.estimator = RSI_ESTIMATOR_PUBLISHED;
    parameters.warning_indicator = RSI_INDICATOR_PUBLISHED;
    parameters.roll_angle_reference = RSI_ROLL_AGAINST_ROAD;
    parameters.roll_angle_sensor = RSI_ROLL_SENSOR_FITTED;
    parameters.vehicle_motion_sensors = RSI_MOTION_WITH_STEERING;
    return parameters;
}

#endif
