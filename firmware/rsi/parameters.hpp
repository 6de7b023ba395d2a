// The calibration's fields by name, and its validation.
#pragma once

#include "rsi/language.hpp"

#include <array>
#include <cstdint>

#include "rsi/output_table.hpp"
#include "rsi/types.hpp"

namespace rsi {

// One number of the calibration. `minimum` and `maximum` are both admitted.
struct ParameterField {
    const char* name;
    float Parameters::* member;
    float minimum;
    float maximum;
};

// One selection of the calibration: the value is the index into `choices`.
struct SelectionField {
    const char* name;
    std::int32_t Parameters::* member;
    const char* const* choices;
    std::int32_t choice_count;
    std::int32_t
        choices_in_layout;  // how many there were when the layout of sections was fixed; later ones follow
};

// Every float field of Parameters, in its order; a test holds the count against the structure's size.
inline constexpr std::array<ParameterField, 65> parameter_fields{{
    {"sprung_mass_kg", &Parameters::sprung_mass_kg, 100.0F, 60000.0F},
    {"sprung_cg_height_m", &Parameters::sprung_cg_height_m, 0.2F, 4.0F},
    {"track_width_m", &Parameters::track_width_m, 0.8F, 3.0F},
    {"roll_inertia_kgm2", &Parameters::roll_inertia_kgm2, 10.0F, 1.0e5F},
    {"unsprung_mass_kg", &Parameters::unsprung_mass_kg, 0.0F, 2.0e4F},
    {"unsprung_cg_height_m", &Parameters::unsprung_cg_height_m, 0.0F, 2.0F},
    {"fixed_roll_centre_height_m", &Parameters::fixed_roll_centre_height_m, -0.5F, 2.0F},
    {"roll_stiffness_nmprad", &Parameters::roll_stiffness_nmprad, 1.0e3F, 1.0e7F},
    {"roll_damping_nmsprad", &Parameters::roll_damping_nmsprad, 1.0e2F, 1.0e6F},
    {"roll_stiffness_cubic_nmprad3", &Parameters::roll_stiffness_cubic_nmprad3, -1.0e8F, 1.0e8F},
    {"roll_stiffness_quintic_nmprad5", &Parameters::roll_stiffness_quintic_nmprad5, -1.0e10F, 1.0e10F},
    {"wheelbase_m", &Parameters::wheelbase_m, 1.0F, 15.0F},
    {"steering_ratio", &Parameters::steering_ratio, 1.0F, 60.0F},
    {"understeer_gradient_s2pm", &Parameters::understeer_gradient_s2pm, -0.01F, 0.1F},
    {"largest_lateral_acceleration_mps2", &Parameters::largest_lateral_acceleration_mps2, 1.0F, 20.0F},
    {"lateral_response_frequency_radps", &Parameters::lateral_response_frequency_radps, 0.0F, 60.0F},
    {"lateral_response_damping", &Parameters::lateral_response_damping, 0.2F, 3.0F},
    {"imu_x_m", &Parameters::imu_x_m, -10.0F, 10.0F},
    {"imu_y_m", &Parameters::imu_y_m, -2.0F, 2.0F},
    {"imu_z_m", &Parameters::imu_z_m, -3.0F, 3.0F},
    {"angular_acceleration_lag_s", &Parameters::angular_acceleration_lag_s, 0.0F, 1.0F},
    {"forgetting_factor", &Parameters::forgetting_factor, 0.9F, 1.0F},
    {"disturbance_cutoff_hz", &Parameters::disturbance_cutoff_hz, 0.0F, 50.0F},
    {"regression_scale_nm", &Parameters::regression_scale_nm, 1.0F, 1.0e5F},
    {"initial_roll_centre_deviation_m", &Parameters::initial_roll_centre_deviation_m, 1.0e-3F, 10.0F},
    {"initial_stiffness_deviation_nmprad", &Parameters::initial_stiffness_deviation_nmprad, 1.0F, 1.0e6F},
    {"initial_damping_deviation_nmsprad", &Parameters::initial_damping_deviation_nmsprad, 1.0F, 1.0e6F},
    {"covariance_limit", &Parameters::covariance_limit, 3.0F, 1.0e6F},
    {"roll_centre_prior_deviation_m", &Parameters::roll_centre_prior_deviation_m, 1.0e-3F, 1.0F},
    {"roll_centre_limit_m", &Parameters::roll_centre_limit_m, 0.01F, 1.0F},
    {"roll_centre_reversion_s", &Parameters::roll_centre_reversion_s, 0.05F, 1.0e4F},
    {"estimator_filter_lag_s", &Parameters::estimator_filter_lag_s, 0.0F, 1.0F},
    {"excitation_threshold_mps2", &Parameters::excitation_threshold_mps2, 0.1F, 20.0F},
    {"freeze_level", &Parameters::freeze_level, 0.1F, 20.0F},
    {"load_transfer_inertial_weight", &Parameters::load_transfer_inertial_weight, 0.0F, 1.0F},
    {"prediction_horizon_s", &Parameters::prediction_horizon_s, 0.0F, 0.5F},
    {"acceleration_trend_s", &Parameters::acceleration_trend_s, 0.02F, 5.0F},
    {"response_horizon_s", &Parameters::response_horizon_s, 0.0F, 0.5F},
    {"response_margin_per_s", &Parameters::response_margin_per_s, 0.0F, 10.0F},
    {"forecast_share", &Parameters::forecast_share, 0.0F, 1.0F},
    {"forecast_limit", &Parameters::forecast_limit, 0.0F, 1.0F},
    {"prediction_filter_lag_s", &Parameters::prediction_filter_lag_s, 0.0F, 0.5F},
    {"load_adaptation", &Parameters::load_adaptation, 0.0F, 1.0F},
    {"load_margin", &Parameters::load_margin, 0.0F, 1.0F},
    {"rollover_index_angle_weight", &Parameters::rollover_index_angle_weight, 0.0F, 1.0F},
    {"rollover_index_acceleration_weight", &Parameters::rollover_index_acceleration_weight, 0.0F, 1.0F},
    {"rollover_index_slope_radps", &Parameters::rollover_index_slope_radps, -100.0F, 100.0F},
    {"rollover_index_roll_angle_rad", &Parameters::rollover_index_roll_angle_rad, 0.01F, 1.5F},
    {"rollover_index_roll_rate_radps", &Parameters::rollover_index_roll_rate_radps, 0.01F, 10.0F},
    {"rollover_index_acceleration_mps2", &Parameters::rollover_index_acceleration_mps2, 0.5F, 20.0F},
    {"time_to_rollover_limit_s", &Parameters::time_to_rollover_limit_s, 0.01F, 5.0F},
    {"observer_bank_drift_radps", &Parameters::observer_bank_drift_radps, 0.0F, 1.0F},
    {"observer_disagreement_rad", &Parameters::observer_disagreement_rad, 0.005F, 1.0F},
    {"observer_disagreement_s", &Parameters::observer_disagreement_s, 0.05F, 10.0F},
    {"observer_margin", &Parameters::observer_margin, 0.0F, 0.5F},
    {"advisory_on", &Parameters::advisory_on, 0.01F, 20.0F},
    {"advisory_off", &Parameters::advisory_off, 0.0F, 20.0F},
    {"warning_on", &Parameters::warning_on, 0.01F, 20.0F},
    {"warning_off", &Parameters::warning_off, 0.0F, 20.0F},
    {"warning_confirmation_s", &Parameters::warning_confirmation_s, 0.0F, 1.0F},
    {"advisory_hold_s", &Parameters::advisory_hold_s, 0.0F, 60.0F},
    {"warning_hold_s", &Parameters::warning_hold_s, 0.0F, 60.0F},
    {"recovery_s", &Parameters::recovery_s, 0.0F, 60.0F},
    {"accelerometer_noise_mps2", &Parameters::accelerometer_noise_mps2, 0.0F, 2.0F},
    {"speed_resolution_mps", &Parameters::speed_resolution_mps, 0.0F, 1.0F},
}};

inline constexpr std::array<const char*, 2> estimator_choices{{"published", "consider_kalman"}};

inline constexpr std::array<const char*, 2> roll_angle_reference_choices{{"road", "horizon"}};

inline constexpr std::array<const char*, 2> roll_angle_sensor_choices{{"fitted", "none"}};

inline constexpr std::array<const char*, 3> vehicle_motion_sensors_choices{
    {"with_steering", "without_steering", "none"}};

inline constexpr std::array<SelectionField, 5> selection_fields{{
    {"estimator", &Parameters::estimator, estimator_choices.data(),
     static_cast<std::int32_t>(estimator_choices.size()), 2},
    {"warning_indicator", &Parameters::warning_indicator, indicator_choices.data(),
     static_cast<std::int32_t>(indicator_choices.size()), 12},
    {"roll_angle_reference", &Parameters::roll_angle_reference, roll_angle_reference_choices.data(),
     static_cast<std::int32_t>(roll_angle_reference_choices.size()), 2},
    {"roll_angle_sensor", &Parameters::roll_angle_sensor, roll_angle_sensor_choices.data(),
     static_cast<std::int32_t>(roll_angle_sensor_choices.size()), 2},
    {"vehicle_motion_sensors", &Parameters::vehicle_motion_sensors, vehicle_motion_sensors_choices.data(),
     static_cast<std::int32_t>(vehicle_motion_sensors_choices.size()), 3},
}};

// Accepts, or names the first field that is refused and why.
[[gnu::cold]] Validation validate(const Parameters& parameters);

}  // namespace rsi
