#include "sil/judge/index_score.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "sil/judge/warning_judgement.hpp"

namespace sil {
namespace {

constexpr double ratio_of_thresholds = 1.01;
constexpr double share_rounding = 1.0e-9;  // a share times its runs is a whole number, but for rounding
constexpr double least_matched_threshold = 1.0e-9;

// The highest level until then. At a threshold above it nothing can have begun to warn.
double peak_until(const IndexCourse& course, double time_s) {
    double peak = 0.0;
    for (std::size_t k = 0U; k < course.risks.size() && course.times_s[k] <= time_s + time_rounding_s; ++k) {
        const auto level = static_cast<double>(course.risks[k].indicator);
        peak = level > peak ? level : peak;  // NaN is no level
    }
    return peak;
}

// The largest threshold, at most `limit`, at which `warns`; 0 when there is none.
double largest_at_which(const std::function<bool(double)>& warns, double limit) {
    const double from = std::clamp(limit, 0.5 * smallest_threshold, largest_threshold);
    auto power = std::lround(std::ceil(std::log(from) / std::log(ratio_of_thresholds)));
    for (;; --power) {
        const double threshold = std::pow(ratio_of_thresholds, static_cast<double>(power));
        if (threshold < smallest_threshold) {
            return 0.0;
        }
        if (threshold <= largest_threshold && warns(threshold)) {
            return threshold;
        }
    }
}

}  // namespace

IndexWarning::IndexWarning(const rsi::Parameters& calibration, double threshold)
    : scale_{static_cast<float>(static_cast<double>(calibration.warning_on) / threshold)},
      constants_{calibration} {}

// Most samples are calm ones: they leave a machine that is ready as it is. A level without a number is not
// calm.
void IndexWarning::update(const rsi::RiskLevel& risk) {
    const float level = risk.indicator * scale_;
    if (level >= 0.0F && level < constants_.advisory_on && machine_.state() == RSI_STATE_READY) {
        return;
    }
    machine_.update(constants_, {level, risk.side, risk.opposite * scale_});
}

rsi::RiskLevel risk_of(float right, float left) {
    return right >= left ? rsi::RiskLevel{right, 1.0F, left} : rsi::RiskLevel{left, -1.0F, right};
}

bool index_alarms(const IndexCourse& course, const rsi::Parameters& calibration, double threshold) {
    IndexWarning warning{calibration, threshold};
    return std::any_of(course.risks.begin(), course.risks.end(), [&warning](const rsi::RiskLevel& risk) {
        warning.update(risk);
        return warning.state() == WarningState::warning;
    });
}

double alarm_threshold(const IndexCourse& course, const rsi::Parameters& calibration) {
    const double peak = course.times_s.empty() ? 0.0 : peak_until(course, course.times_s.back());
    double at = 0.0;
    double beyond = peak;
    for (int halving = 0; halving < 32 && peak > 0.0; ++halving) {
        const double threshold = 0.5 * (at + beyond);
        (index_alarms(course, calibration, threshold) ? at : beyond) = threshold;
    }
    return at;
}

double matched_threshold(std::vector<double> alarm_thresholds, double share) {
    const auto wanted =
        std::lround(std::ceil(share * static_cast<double>(alarm_thresholds.size()) - share_rounding));
    if (wanted <= 0) {
        return std::numeric_limits<double>::infinity();
    }
    std::sort(alarm_thresholds.begin(), alarm_thresholds.end(), std::greater<>{});
    const auto place = std::min(static_cast<std::size_t>(wanted), alarm_thresholds.size()) - 1U;
    return std::max(alarm_thresholds.at(place), least_matched_threshold);
}

std::optional<double> index_lead_s(const IndexCourse& course, const rsi::Parameters& calibration,
                                   double threshold, const TwoWheelLiftOff& lift_off) {
    IndexWarning warning{calibration, threshold};
    WarningInForce in_force;
    for (std::size_t k = 0U; k < course.risks.size(); ++k) {
        if (course.times_s[k] > lift_off.moment.time_s + time_rounding_s) {
            break;
        }
        warning.update(course.risks[k]);
        in_force.observe(warning.state(), warning.side(), course.times_s[k]);
    }
    return in_force.lead_s(lift_off.moment.time_s, lift_off.side);
}

IndexScore score_of(const IndexCourse& course, const rsi::Parameters& calibration,
                    const std::optional<TwoWheelLiftOff>& lift_off) {
    IndexScore score;
    if (!lift_off) {
        const double peak = course.times_s.empty() ? 0.0 : peak_until(course, course.times_s.back());
        score.threshold = largest_at_which(
            [&](double threshold) { return index_alarms(course, calibration, threshold); }, peak);
        score.threshold_100ms = score.threshold;
        score.threshold_200ms = score.threshold;
        return score;
    }
    const auto largest_with_lead = [&](double wanted_s, double limit) {
        return largest_at_which(
            [&](double threshold) {
                return is_warned(index_lead_s(course, calibration, threshold, *lift_off), wanted_s);
            },
            std::min(limit, peak_until(course, lift_off->moment.time_s - wanted_s)));
    };
    score.threshold = largest_with_lead(0.0, largest_threshold);
    score.threshold_100ms = score.threshold > 0.0 ? largest_with_lead(early_s, score.threshold) : 0.0;
    score.threshold_200ms =
        score.threshold_100ms > 0.0 ? largest_with_lead(very_early_s, score.threshold_100ms) : 0.0;
    score.lead_s = index_lead_s(course, calibration, 1.0, *lift_off);
    return score;
}

}  // namespace sil
