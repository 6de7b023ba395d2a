#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "rsi/parameters.hpp"
#include "rsi/prediction/linear_forecast.hpp"
#include "sil/judge/detection.hpp"
#include "sil/judge/index_score.hpp"
#include "sil/judge/judge.h"
#include "sil/judge/warning_judgement.hpp"

namespace {

std::optional<double> known(double value) {
    return std::isnan(value) ? std::nullopt : std::optional{value};
}

double or_nan(const std::optional<double>& value) {
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

sil::RunKind kind_of(const judge_runs& runs, std::size_t place) {
    return {runs.vehicles == nullptr ? 0U : runs.vehicles[place],
            known(runs.lift_off_times_s[place]).has_value(),
            sil::load_band(runs.largest_load_transfer_ratios[place])};
}

rsi::Parameters parameters_of(const judge_calibration& calibration) {
    rsi::Parameters parameters{};
    parameters.advisory_on = calibration.advisory_on;
    parameters.advisory_off = calibration.advisory_off;
    parameters.warning_on = calibration.warning_on;
    parameters.warning_off = calibration.warning_off;
    parameters.warning_confirmation_s = calibration.warning_confirmation_s;
    parameters.advisory_hold_s = calibration.advisory_hold_s;
    parameters.warning_hold_s = calibration.warning_hold_s;
    parameters.recovery_s = calibration.recovery_s;
    return parameters;
}

sil::IndexCourse course_of(const judge_course& given) {
    sil::IndexCourse course;
    for (std::size_t k = 0U; k < given.cycles; ++k) {
        course.times_s.push_back(given.times_s[k]);
        course.risks.push_back(
            sil::risk_of(static_cast<float>(given.right[k]), static_cast<float>(given.left[k])));
    }
    return course;
}

rsi::Parameters parameters_of(std::size_t count, const char* const* names, const double* values) {
    rsi::Parameters parameters{};
    for (std::size_t k = 0U; k < count; ++k) {
        for (const rsi::ParameterField& field : rsi::parameter_fields) {
            if (std::string_view{names[k]} == field.name) {
                parameters.*field.member = static_cast<float>(values[k]);
            }
        }
    }
    return parameters;
}

judge_share share_of(const sil::Share& share) {
    const sil::ConfidenceInterval confidence = share.confidence();
    return {share.count, share.total, confidence.lowest, confidence.highest};
}

}  // namespace

extern "C" {

const double judge_early_s = sil::early_s;
const double judge_very_early_s = sil::very_early_s;
const double judge_time_rounding_s = sil::time_rounding_s;
const double judge_lasting_s = sil::TwoWheelLiftObserver::lasting_s;
const size_t judge_forecast_input_count = rsi::ForecastMatrix::SizeAtCompileTime;
const size_t judge_fewest_clusters = sil::fewest_clusters;

const char* judge_band_name(size_t band) {
    static_assert(JUDGE_BANDS == sil::band_count);
    return to_string(sil::load_bands[band]);
}

void judge_each(const judge_runs* runs, uint8_t* lifted, uint8_t* calm, uint8_t* warned,
                uint8_t* warned_100ms, uint8_t* warned_200ms, uint8_t* band) {
    for (std::size_t place = 0U; place < runs->count; ++place) {
        const sil::RunKind run = kind_of(*runs, place);
        const sil::WarningInRun warning = sil::warning_in_run(known(runs->leads_s[place]), false);
        lifted[place] = run.lifted ? 1U : 0U;
        calm[place] = sil::is_calm(run.lifted, run.band) ? 1U : 0U;
        warned[place] = run.lifted && warning.warned ? 1U : 0U;
        warned_100ms[place] = run.lifted && warning.warned_100ms ? 1U : 0U;
        warned_200ms[place] = run.lifted && warning.warned_200ms ? 1U : 0U;
        band[place] = static_cast<uint8_t>(run.band);
    }
}

void judge_detect(const judge_runs* runs, judge_detection* detection) {
    sil::DetectionCounts counts;
    for (std::size_t place = 0U; place < runs->count; ++place) {
        counts.add(kind_of(*runs, place), known(runs->leads_s[place]), runs->alarms[place] != 0U);
    }
    const sil::Detection found = counts.detection();
    detection->warned = share_of(found.warned);
    detection->warned_100ms = share_of(found.warned_100ms);
    detection->warned_200ms = share_of(found.warned_200ms);
    detection->false_alarms = share_of(found.false_alarms);
    for (std::size_t band = 0U; band < sil::band_count; ++band) {
        detection->alarms[band] = share_of(found.alarms[band]);
    }
    detection->median_lead_s = or_nan(found.median_lead_s);
}

double judge_lead_s(size_t count, const double* times_s, const uint8_t* sides, double lift_off_time_s,
                    uint8_t falling_side) {
    sil::WarningInForce in_force;
    for (std::size_t k = 0U; k < count && times_s[k] <= lift_off_time_s + sil::time_rounding_s; ++k) {
        in_force.observe(sil::WarningState::warning, static_cast<sil::WarningSide>(sides[k]), times_s[k]);
    }
    return or_nan(in_force.lead_s(lift_off_time_s, static_cast<sil::WarningSide>(falling_side)));
}

double judge_index_lead_s(const judge_calibration* calibration, const judge_course* course, double threshold,
                          double lift_off_time_s, uint8_t falling_side) {
    return or_nan(
        sil::index_lead_s(course_of(*course), parameters_of(*calibration), threshold,
                          {{lift_off_time_s, 0.0, 0.0}, static_cast<sil::WarningSide>(falling_side)}));
}

int judge_alarms(const judge_calibration* calibration, const judge_course* course, double threshold) {
    return sil::index_alarms(course_of(*course), parameters_of(*calibration), threshold) ? 1 : 0;
}

double judge_alarm_threshold(const judge_calibration* calibration, const judge_course* course) {
    return sil::alarm_threshold(course_of(*course), parameters_of(*calibration));
}

double judge_matched_threshold(size_t runs, const double* alarm_thresholds, double share) {
    return sil::matched_threshold({alarm_thresholds, alarm_thresholds + runs}, share);
}

void judge_warnings(const judge_drive* drive, judge_judgement* judgement) {
    sil::WarningJudge judge;
    for (std::size_t k = 0U; k < drive->cycles; ++k) {
        judge.observe(drive->times_s[k], drive->load_transfer_ratios[k]);
        judge.observe(static_cast<sil::WarningState>(drive->states[k]),
                      static_cast<sil::WarningSide>(drive->sides[k]), drive->times_s[k]);
    }
    if (known(drive->lift_off_time_s)) {
        judge.lift_off(
            {{drive->lift_off_time_s, 0.0, 0.0}, static_cast<sil::WarningSide>(drive->falling_side)});
    }
    const sil::WarningJudgement& found = judge.judgement();
    judgement->lifted = found.lifted ? 1U : 0U;
    judgement->side_at_lift_off = static_cast<uint8_t>(found.side_at_lift_off);
    judgement->late = found.late ? 1U : 0U;
    judgement->lead_s = or_nan(found.lead_s);
    judgement->wrong_side_s = found.wrong_side_s;
    judgement->warning_s = found.warning_s;
    judgement->advisory_s = found.advisory_s;
    judgement->unavailable_s = found.unavailable_s;
    judgement->warnings = found.warnings;
    judgement->advisories = found.advisories;
    judgement->largest_load_transfer_ratio = found.largest_load_transfer_ratio;
    judgement->band = static_cast<uint8_t>(found.band());
}

void judge_forecast_inputs(size_t parameters, const char* const* names, const double* values,
                           const judge_signals* signals, double* inputs) {
    const rsi::Parameters calibration = parameters_of(parameters, names, values);
    const rsi::Vehicle vehicle{calibration};
    const rsi::SteeringDemand steering{calibration};
    rsi::LinearForecast forecast;
    for (std::size_t k = 0U; k < signals->cycles; ++k) {
        rsi::Inputs sensed{};
        sensed.yaw_rate_radps = static_cast<float>(signals->yaw_rate_radps[k]);
        sensed.speed_mps = static_cast<float>(signals->speed_mps[k]);
        sensed.steering_wheel_angle_rad = static_cast<float>(signals->steering_wheel_angle_rad[k]);
        rsi::Measurement measured;
        measured.road_parallel_force_mps2 = static_cast<float>(signals->road_parallel_force_mps2[k]);
        measured.lateral_acceleration_mps2 = measured.road_parallel_force_mps2;
        measured.roll_rate_radps = static_cast<float>(signals->roll_rate_radps[k]);
        measured.roll_angle_rad = static_cast<float>(signals->roll_angle_rad[k]);
        if (std::isfinite(measured.road_parallel_force_mps2) && std::isfinite(measured.roll_angle_rad)) {
            forecast.update(vehicle, sensed, measured, steering.evaluate(sensed, measured));
        } else {
            forecast = rsi::LinearForecast{};  // no measurement
        }
        const rsi::ForecastMatrix& lagged = forecast.lagged();
        for (Eigen::Index signal = 0; signal < lagged.rows(); ++signal) {
            for (Eigen::Index lag = 0; lag < lagged.cols(); ++lag) {
                *inputs = static_cast<double>(lagged(signal, lag));
                ++inputs;
            }
        }
    }
}

void judge_wilson_interval(double count, double total, double* lowest, double* highest) {
    const sil::ConfidenceInterval interval = sil::wilson_interval(count, total);
    *lowest = interval.lowest;
    *highest = interval.highest;
}

void judge_share_by_vehicle(size_t vehicles, const size_t* counts, const size_t* totals, judge_share* share) {
    sil::ShareByVehicle all;
    for (std::size_t vehicle = 0U; vehicle < vehicles; ++vehicle) {
        all.add(vehicle, counts[vehicle], totals[vehicle]);
    }
    *share = share_of(all.share());
}

}  // extern "C"
