// A large SUV's calibration and ordinary sensor values, as the unit tests use them.
#pragma once

#include "rsi/rsi.h"

namespace rsi_test {

constexpr double gravity_mps2 = 9.80665;
constexpr double pi = 3.14159265358979323846;

inline rsi_parameters large_suv() {
    rsi_parameters parameters{};
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
    parameters.covariance_limit = 100.0F;
    parameters.advisory_on = 0.8F;
    parameters.advisory_off = 0.7F;
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

// The vehicle stands on a flat road.
inline rsi_inputs at_rest() {
    rsi_inputs inputs{};
    inputs.vertical_specific_force_mps2 = static_cast<float>(gravity_mps2);
    return inputs;
}

}  // namespace rsi_test
