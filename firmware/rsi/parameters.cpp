#include "rsi/parameters.hpp"

#include "rsi/model/critical_roll_angle.hpp"
#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

constexpr Validation accepted{1, "", ""};

constexpr Validation refuse(const char* field, const char* reason) {
    return Validation{0, field, reason};
}

Validation validate_ranges(const Parameters& parameters) {
    for (const ParameterField& field : parameter_fields) {
        const float value = parameters.*field.member;
        if (!is_finite(value)) {
            return refuse(field.name, "is not a finite number");
        }
        if (value < field.minimum) {
            return refuse(field.name, "is below its range");
        }
        if (value > field.maximum) {
            return refuse(field.name, "is above its range");
        }
    }
    for (const SelectionField& field : selection_fields) {
        const std::int32_t value = parameters.*field.member;
        if ((value < 0) || (value >= field.choice_count)) {
            return refuse(field.name, "is not one of its choices");
        }
    }
    return accepted;
}

// M(phi) / phi at phi^2 = z.
float secant_stiffness_nmprad(const Parameters& parameters, float z) {
    return parameters.roll_stiffness_nmprad +
           z * (parameters.roll_stiffness_cubic_nmprad3 + z * parameters.roll_stiffness_quintic_nmprad5);
}

// The least of it up to the angle at which the inner wheels lift.
float least_stiffness_nmprad(const Parameters& parameters, float critical_angle_rad) {
    const float K_2 = parameters.roll_stiffness_cubic_nmprad3;
    const float K_4 = parameters.roll_stiffness_quintic_nmprad5;
    const float furthest = critical_angle_rad * critical_angle_rad;
    float least = secant_stiffness_nmprad(parameters, furthest);
    // The parabola opens upwards, so K_4 > 0 where its vertex matters.
    if ((K_4 > 0.0F) && (K_2 < 0.0F) && (-K_2 < 2.0F * K_4 * furthest)) {
        least = secant_stiffness_nmprad(parameters, -K_2 / (2.0F * K_4));
    }
    return least;
}

Validation validate_vehicle(const Parameters& parameters) {
    const float H = roll_arm_m(parameters);
    if (H < 0.01F) {
        return refuse("fixed_roll_centre_height_m", "must lie below sprung_cg_height_m");
    }
    // Beyond this the angle at which the CG leaves the track lies outside what the component can tell apart.
    if (parameters.track_width_m > 6.0F * parameters.sprung_cg_height_m) {
        return refuse("track_width_m", "must not exceed six times sprung_cg_height_m");
    }
    if (parameters.roll_stiffness_nmprad < 1.2F * parameters.sprung_mass_kg * gravity_mps2 * H) {
        return refuse("roll_stiffness_nmprad",
                      "does not hold the body up: it must exceed 1.2 m_s g (h_cg,s - h_frc)");
    }
    // The model's time constant must be resolved by the fixed step.
    if (parameters.roll_damping_nmsprad < 0.5F * sample_time_s * parameters.roll_stiffness_nmprad) {
        return refuse("roll_damping_nmsprad",
                      "is too small for a step of 10 ms: c_f / K_f must be at least 5 ms");
    }
    const float critical_angle_rad = critical_roll_angle_rad(parameters);
    if (!is_finite(critical_angle_rad)) {
        return refuse("roll_stiffness_nmprad",
                      "is too small for this track width: no roll angle below 1 rad lifts the inner wheels");
    }
    if (least_stiffness_nmprad(parameters, critical_angle_rad) <
        parameters.sprung_mass_kg * gravity_mps2 * H) {
        return refuse((parameters.roll_stiffness_cubic_nmprad3 < 0.0F) ? "roll_stiffness_cubic_nmprad3"
                                                                       : "roll_stiffness_quintic_nmprad5",
                      "bends the roll stiffness below m_s g (h_cg,s - h_frc) before the inner wheels lift");
    }
    return accepted;
}

// A response that takes seconds is none: the prediction would hold A still.
constexpr float slowest_response_radps = 1.0F;

Validation validate_steering(const Parameters& parameters) {
    const float w = parameters.lateral_response_frequency_radps;
    if ((w > 0.0F) && (w < slowest_response_radps)) {
        return refuse("lateral_response_frequency_radps", "must be 0, not known, or at least 1 rad/s");
    }
    return accepted;
}

Validation validate_indicators(const Parameters& parameters) {
    if (parameters.rollover_index_angle_weight + parameters.rollover_index_acceleration_weight > 1.0F) {
        return refuse("rollover_index_acceleration_weight",
                      "must not exceed 1 less rollover_index_angle_weight");
    }
    return accepted;
}

// Every level is 1 where the inner wheels lift: the present load transfer's to the point, that of the others,
// which look ahead or judge by less, up to a fifth above it before.
constexpr float largest_warning_level = 1.2F;
// From a load transfer of 0.9 to the lift of the wheels many vehicles need no more.
constexpr float longest_confirmation_s = 0.2F;
// Longer, and one lost frame takes a whole manoeuvre from the warning.
constexpr float longest_recovery_s = 2.0F;

// Settings that could not warn before the wheels lift, or hardly ever.
Validation validate_timeliness(const Parameters& parameters) {
    if (parameters.warning_on > largest_warning_level) {
        return refuse("warning_on",
                      "must not exceed 1.2: every level is about 1 when the inner wheels lift, so no "
                      "warning would come before");
    }
    if ((parameters.warning_indicator == RSI_INDICATOR_LOAD_TRANSFER) && (parameters.warning_on > 1.0F)) {
        return refuse("warning_on", "must not exceed 1: the load transfer is 1 when the inner wheels lift");
    }
    if (parameters.warning_confirmation_s > longest_confirmation_s) {
        return refuse("warning_confirmation_s",
                      "must not exceed 0.2 s: the wheels would lift before the warning is confirmed");
    }
    if (parameters.recovery_s > longest_recovery_s) {
        return refuse("recovery_s",
                      "must not exceed 2 s: a lost frame would silence the warning for a whole manoeuvre");
    }
    return accepted;
}

Validation validate_warning(const Parameters& parameters) {
    if (parameters.advisory_off > parameters.advisory_on) {
        return refuse("advisory_off", "must not exceed advisory_on");
    }
    if (parameters.warning_off > parameters.warning_on) {
        return refuse("warning_off", "must not exceed warning_on");
    }
    if (parameters.advisory_on > parameters.warning_on) {
        return refuse("advisory_on", "must not exceed warning_on");
    }
    if ((parameters.warning_indicator == RSI_INDICATOR_PUBLISHED) && (parameters.warning_on > 1.0F)) {
        return refuse("warning_on",
                      "must not exceed 1: the published indicator ends there, so no warning could come");
    }
    if (parameters.warning_indicator == RSI_INDICATOR_TIME_TO_ROLLOVER) {
        // The time is cut to 0.01 to 10 s, and the level to its limit over that.
        if (parameters.warning_on > 100.0F * parameters.time_to_rollover_limit_s) {
            return refuse("warning_on", "exceeds what time_to_rollover_limit_s lets the level reach");
        }
        if (parameters.advisory_off <= 0.1F * parameters.time_to_rollover_limit_s) {
            return refuse("advisory_off",
                          "must exceed a tenth of time_to_rollover_limit_s, which is the level at rest");
        }
    }
    return accepted;
}

}  // namespace

Validation validate(const Parameters& parameters) {
    Validation answer = validate_ranges(parameters);
    if (answer.accepted != 0) {
        answer = validate_vehicle(parameters);
    }
    if (answer.accepted != 0) {
        answer = validate_steering(parameters);
    }
    if (answer.accepted != 0) {
        answer = validate_indicators(parameters);
    }
    if (answer.accepted != 0) {
        answer = validate_warning(parameters);
    }
    if (answer.accepted != 0) {
        answer = validate_timeliness(parameters);
    }
    return answer;
}

}  // namespace rsi
