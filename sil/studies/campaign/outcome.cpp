// Outcome: lift-offs that last are told from those that do not.
#include "sil/studies/campaign/outcome.hpp"

#include <algorithm>
#include <cmath>

#include "sil/results/indices.hpp"
#include "sil/studies/campaign/times.hpp"

namespace sil {
namespace {

// No vehicle here has its balance point, about atan(SSF), beyond it.
constexpr double rolled_over_rad = 1.0;
// After so long on two wheels it is of no more interest whether the vehicle falls or comes back.
constexpr double settled_after_lift_s = 1.0;

}  // namespace

void OutcomeObserver::observe(const Truth& truth) {
    const auto& loads = truth.wheel_load_n;
    if (!outcome_.one_wheel_lift_time_s &&
        std::any_of(loads.begin(), loads.end(), [](double load_n) { return load_n <= 0.0; })) {
        outcome_.one_wheel_lift_time_s = truth.time_s;
    }
    const double ltr = std::abs(true_load_transfer_ratio(truth));
    if (std::isfinite(ltr)) {
        outcome_.largest_ltr = std::max(outcome_.largest_ltr, ltr);
        if (!outcome_.one_wheel_lift_time_s) {
            outcome_.largest_ltr_before_lift = std::max(outcome_.largest_ltr_before_lift, ltr);
        }
    }
    outcome_.largest_lateral_acceleration_mps2 =
        std::max(outcome_.largest_lateral_acceleration_mps2, std::abs(truth.lateral_acceleration_mps2));
    outcome_.largest_roll_angle_rad =
        std::max(outcome_.largest_roll_angle_rad, std::abs(truth.roll_angle_rad));
    outcome_.rolled_over = outcome_.largest_roll_angle_rad > rolled_over_rad;
    outcome_.end_time_s = truth.time_s;
    observe_sides(truth);
}

void OutcomeObserver::observe_sides(const Truth& truth) {
    if (outcome_.two_wheel_lift_time_s) {
        return;
    }
    const bool up = two_wheels_have_lifted(truth);
    if (up && !lift_began_s_) {
        lift_began_s_ = truth.time_s;
    }
    if (!lift_began_s_) {
        return;
    }
    if (up && truth.time_s - *lift_began_s_ >= lasting_lift_s - rounding_s) {
        outcome_.two_wheel_lift_time_s = lift_began_s_;
    } else if (!up) {
        if (!outcome_.brief_two_wheel_lift_time_s) {
            outcome_.brief_two_wheel_lift_time_s = lift_began_s_;
        }
        lift_began_s_.reset();
    }
}

bool OutcomeObserver::settled() const {
    return outcome_.rolled_over ||
           (outcome_.two_wheel_lift_time_s &&
            outcome_.end_time_s - *outcome_.two_wheel_lift_time_s > settled_after_lift_s);
}

Outcome OutcomeObserver::outcome() const {
    Outcome result = outcome_;
    if (!result.two_wheel_lift_time_s && !result.brief_two_wheel_lift_time_s) {
        result.brief_two_wheel_lift_time_s = lift_began_s_;
    }
    return result;
}

}  // namespace sil
