// Outcome: the largest of a run, and its lift-offs.
#include "sil/studies/campaign/outcome.hpp"

#include <algorithm>
#include <cmath>

#include "sil/results/indices.hpp"

namespace sil {

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
    outcome_.distance_m += truth.speed_mps * (truth.time_s - outcome_.end_time_s);
    outcome_.end_time_s = truth.time_s;
    lift_.observe({truth.time_s, truth.lateral_acceleration_mps2, truth.roll_angle_rad},
                  left_side_has_lifted(truth), right_side_has_lifted(truth));
    if (lift_.lift_off()) {
        outcome_.two_wheel_lift_time_s = lift_.lift_off()->moment.time_s;
    }
    outcome_.brief_two_wheel_lift_time_s = lift_.brief_time_s();
}

bool OutcomeObserver::settled() const {
    return outcome_.rolled_over ||
           (outcome_.two_wheel_lift_time_s &&
            outcome_.end_time_s - *outcome_.two_wheel_lift_time_s > settled_after_lift_s);
}

}  // namespace sil
