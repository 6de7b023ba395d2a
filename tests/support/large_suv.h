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
    parameters.advisory_on = 0.9F;
    parameters.advisory_off = 0.8F;
    parameters.warning_on = 1.0F;
    parameters.warning_off = 0.9F;
    parameters.warning_confirmation_s = 0.02F;
    parameters.advisory_hold_s = 0.5F;
    parameters.warning_hold_s = 1.0F;
    parameters.recovery_s = 0.1F;
    parameters.estimator = RSI_ESTIMATOR_PUBLISHED;
    parameters.warning_indicator = RSI_INDICATOR_PUBLISHED;
    return parameters;
}

#endif
