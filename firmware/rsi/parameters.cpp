#include "rsi/parameters.hpp"

#include "rsi/indicator/energy_margin.hpp"
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

Validation validate_vehicle(const Parameters& parameters) {
    const float H = parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m;
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
    if (!is_finite(critical_roll_angle_rad(parameters))) {
        return refuse("roll_stiffness_nmprad",
                      "is too small for this track width: no roll angle below 1 rad lifts the inner wheels");
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
    return accepted;
}

}  // namespace

Validation validate(const Parameters& parameters) {
    Validation answer = validate_ranges(parameters);
    if (answer.accepted != 0) {
        answer = validate_vehicle(parameters);
    }
    if (answer.accepted != 0) {
        answer = validate_indicators(parameters);
    }
    if (answer.accepted != 0) {
        answer = validate_warning(parameters);
    }
    return answer;
}

}  // namespace rsi
