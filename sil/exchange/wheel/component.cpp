#include "sil/exchange/wheel/component.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rsi/output_table.hpp"
#include "rsi/parameters.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/judge/firmware_indices.hpp"
#include "sil/judge/index_score.hpp"
#include "sil/simulation/component_inputs.hpp"
#include "sil/studies/drives/lift_off.hpp"

namespace {

using Fields = std::vector<component_field>;

Fields inputs() {
    Fields fields;
    for (const sil::ComponentInput& input : sil::component_inputs) {
        fields.push_back({input.name, input.meaning});
    }
    return fields;
}

Fields parameters() {
    Fields fields;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        fields.push_back({field.name, ""});
    }
    return fields;
}

Fields selections() {
    static std::array<std::string, rsi::selection_fields.size()> choices;
    Fields fields;
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        std::string& text = choices[fields.size()];
        for (std::int32_t choice = 0; choice < field.choice_count; ++choice) {
            text += (text.empty() ? "" : ", ") + std::string{field.choices[choice]};
        }
        fields.push_back({field.name, text.c_str()});
    }
    return fields;
}

#define NOTHING(...)
#define CODE(name, reset, largest, risk, meaning) component_field{#name, meaning},
#define NUMBER(name, unit, mirror, presence, risk, meaning) component_field{#name, "[" unit "] " meaning},
#define INDEX(name, unit, mirror, CHOICE, number, choice, scale, side, meaning) \
    component_field{#name, "[" unit "] " meaning},
#define CHOICE_OF(name, unit, mirror, CHOICE, number, choice, scale, side, meaning) \
    component_field{#choice, #name},

// By kind.
const Fields& fields_of(int kind) {
    static const Fields all[] = {inputs(),
                                 {RSI_OUTPUTS(CODE, NOTHING, NOTHING)},
                                 {RSI_OUTPUTS(NOTHING, NUMBER, INDEX)},
                                 parameters(),
                                 selections(),
                                 {RSI_OUTPUTS(NOTHING, NOTHING, CHOICE_OF)}};
    return all[static_cast<std::size_t>(kind)];
}

#undef CHOICE_OF
#undef INDEX
#undef NUMBER
#undef CODE
#undef NOTHING

sil::IndexCourse course_of(const component_course& given) {
    sil::IndexCourse course;
    for (std::size_t k = 0U; k < given.cycles; ++k) {
        const component_risk& risk = given.risks[k * rsi::index_count + given.index];
        course.times_s.push_back(given.times_s[k]);
        course.risks.push_back({risk.level, risk.side, risk.opposite});
    }
    return course;
}

std::optional<sil::TwoWheelLiftOff> lift_off_of(double time_s, uint8_t falling_side) {
    if (std::isnan(time_s)) {
        return std::nullopt;
    }
    return sil::TwoWheelLiftOff{{time_s, 0.0, 0.0}, static_cast<sil::WarningSide>(falling_side)};
}

double or_nan(const std::optional<double>& value) {
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

extern "C" {

const size_t component_size = sizeof(rsi_component);
const char* const component_version = RSI_VERSION;

size_t component_field_count(int kind) {
    return fields_of(kind).size();
}

component_field component_field_at(int kind, size_t place) {
    return fields_of(kind).at(place);
}

int component_load(const char* path, size_t changes, const char* const* texts, rsi_parameters* parameters,
                   char* refusal, size_t room) {
    try {
        *parameters = sil::load_calibration(path, {texts, texts + changes});
        return 1;
    } catch (const std::exception& error) {
        const std::string_view reason{error.what()};
        const std::size_t length = std::min(reason.size(), room - 1U);
        std::memcpy(refusal, reason.data(), length);
        refusal[length] = '\0';
        return 0;
    }
}

void component_start(rsi_component* component, const rsi_parameters* parameters) {
    rsi_init(component, parameters);
}

void component_steps(rsi_component* component, const rsi_parameters* parameters, size_t cycles,
                     const rsi_inputs* inputs, rsi_outputs* outputs, component_risk* risks) {
    const sil::FirmwareIndices indices{*parameters};
    for (std::size_t k = 0U; k < cycles; ++k) {
        rsi_step(component, &inputs[k], &outputs[k]);
        const float roll_angle_rad = sil::roll_angle_in_use(inputs[k], outputs[k]);
        for (std::size_t index = 0U; index < rsi::index_count; ++index) {
            const rsi::RiskLevel risk = indices.risk(index, outputs[k], roll_angle_rad);
            risks[k * rsi::index_count + index] = {risk.indicator, risk.side, risk.opposite};
        }
    }
}

double component_index_lead_s(const component_course* course, double threshold, double lift_off_time_s,
                              uint8_t falling_side) {
    const std::optional<sil::TwoWheelLiftOff> lift_off = lift_off_of(lift_off_time_s, falling_side);
    return lift_off ? or_nan(sil::index_lead_s(course_of(*course), *course->parameters, threshold, *lift_off))
                    : or_nan(std::nullopt);
}

int component_index_alarms(const component_course* course, double threshold) {
    return sil::index_alarms(course_of(*course), *course->parameters, threshold) ? 1 : 0;
}

double component_alarm_threshold(const component_course* course) {
    return sil::alarm_threshold(course_of(*course), *course->parameters);
}

component_score component_index_score(const component_course* course, double lift_off_time_s,
                                      uint8_t falling_side) {
    const sil::IndexScore score =
        sil::score_of(course_of(*course), *course->parameters, lift_off_of(lift_off_time_s, falling_side));
    return {score.threshold, score.threshold_100ms, score.threshold_200ms, or_nan(score.lead_s)};
}

component_lift_off component_find_lift_off(size_t cycles, const double* times_s,
                                           const double* const* wheel_loads_n,
                                           const double* lateral_acceleration_mps2,
                                           double* load_transfer_ratios) {
    sil::Drive drive;
    for (std::size_t k = 0U; k < cycles; ++k) {
        sil::DriveSample sample;
        sample.time_s = times_s[k];
        for (std::size_t wheel = 0U; wheel < sample.wheel_load_n.size(); ++wheel) {
            sample.wheel_load_n[wheel] = wheel_loads_n[wheel][k];
        }
        if (lateral_acceleration_mps2 != nullptr) {
            sample.lateral_acceleration_mps2 = lateral_acceleration_mps2[k];
        }
        load_transfer_ratios[k] = sil::load_transfer_ratio(sample);
        drive.samples.push_back(sample);
    }
    const sil::LiftOff found = sil::find_lift_off(drive);
    const bool known = found.source == sil::LiftOffSource::wheel_loads;
    return {or_nan(found.one_wheel_s), or_nan(found.two_wheel_s),
            known ? found.up_below_n : or_nan(std::nullopt), static_cast<uint8_t>(found.falling_side)};
}

}  // extern "C"
