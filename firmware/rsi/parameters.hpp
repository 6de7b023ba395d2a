// The calibration's fields by name, and its validation.
#pragma once

#include <array>
#include <cstdint>

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
};

// Every float field of Parameters, in its order; a test holds the count against the structure's size.
inline constexpr std::array<ParameterField, 25> parameter_fields{{
    {"sprung_mass_kg", &Parameters::sprung_mass_kg, 100.0F, 60000.0F},
    {"sprung_cg_height_m", &Parameters::sprung_cg_height_m, 0.2F, 4.0F},
    {"track_width_m", &Parameters::track_width_m, 0.8F, 3.0F},
    {"fixed_roll_centre_height_m", &Parameters::fixed_roll_centre_height_m, -0.5F, 2.0F},
    {"roll_stiffness_nmprad", &Parameters::roll_stiffness_nmprad, 1.0e3F, 1.0e7F},
    {"roll_damping_nmsprad", &Parameters::roll_damping_nmsprad, 1.0e2F, 1.0e6F},
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
    {"advisory_on", &Parameters::advisory_on, 0.01F, 20.0F},
    {"advisory_off", &Parameters::advisory_off, 0.0F, 20.0F},
    {"warning_on", &Parameters::warning_on, 0.01F, 20.0F},
    {"warning_off", &Parameters::warning_off, 0.0F, 20.0F},
    {"warning_confirmation_s", &Parameters::warning_confirmation_s, 0.0F, 1.0F},
    {"advisory_hold_s", &Parameters::advisory_hold_s, 0.0F, 60.0F},
    {"warning_hold_s", &Parameters::warning_hold_s, 0.0F, 60.0F},
    {"recovery_s", &Parameters::recovery_s, 0.0F, 60.0F},
}};

inline constexpr std::array<const char*, 1> estimator_choices{{"published"}};
inline constexpr std::array<const char*, 2> indicator_choices{{"published", "bank_free"}};

inline constexpr std::array<SelectionField, 2> selection_fields{{
    {"estimator", &Parameters::estimator, estimator_choices.data(),
     static_cast<std::int32_t>(estimator_choices.size())},
    {"warning_indicator", &Parameters::warning_indicator, indicator_choices.data(),
     static_cast<std::int32_t>(indicator_choices.size())},
}};

// Accepts, or names the first field that is refused and why.
Validation validate(const Parameters& parameters);

}  // namespace rsi
