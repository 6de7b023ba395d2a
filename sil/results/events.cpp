// EventObserver: first lift-offs, first crossing of the SSF, the warning and its judgement.
#include "sil/results/events.hpp"

#include "sil/results/indices.hpp"
#include "sil/units.hpp"

#include <algorithm>
#include <cmath>

namespace sil {
namespace {

bool front_wheel_has_lifted(const Truth& truth) {
    return has_lifted(truth, front_left) || has_lifted(truth, front_right);
}

bool rear_wheel_has_lifted(const Truth& truth) {
    return has_lifted(truth, rear_left) || has_lifted(truth, rear_right);
}

void keep_first(std::optional<EventMoment>& event, bool happens, const EventMoment& moment) {
    if (happens && !event) {
        event = moment;
    }
}

}  // namespace

EventObserver::EventObserver(double static_stability_factor, double start_time_s)
    : ssf_acceleration_mps2_(static_stability_factor * g_mps2), start_time_s_(start_time_s) {}

void EventObserver::observe(const Truth& truth) {
    latest_ = {truth.time_s, truth.lateral_acceleration_mps2, truth.roll_angle_rad};
    const double magnitude_mps2 = std::fabs(truth.lateral_acceleration_mps2);
    if (truth.time_s >= start_time_s_) {
        judge_.observe(truth.time_s, true_load_transfer_ratio(truth));
        observe_lift(truth);
        const bool front_lifted = front_wheel_has_lifted(truth);
        const bool rear_lifted = rear_wheel_has_lifted(truth);
        keep_first(events_.one_wheel_lift, front_lifted || rear_lifted, latest_);
        keep_first(events_.front_axle_lift, front_lifted, latest_);
        keep_first(events_.rear_axle_lift, rear_lifted, latest_);
        keep_first(events_.ssf_crossing, magnitude_mps2 >= ssf_acceleration_mps2_, latest_);
        events_.largest_lateral_acceleration_mps2 =
            std::max(events_.largest_lateral_acceleration_mps2, magnitude_mps2);
    }
    events_.final_roll_angle_rad = truth.roll_angle_rad;
    events_.end_time_s = truth.time_s;
    events_.judgement = judge_.judgement();
}

void EventObserver::observe_lift(const Truth& truth) {
    two_wheel_lift_.observe(latest_, left_side_has_lifted(truth), right_side_has_lifted(truth));
    if (two_wheel_lift_.lift_off() && !events_.two_wheel_lift) {
        events_.two_wheel_lift = two_wheel_lift_.lift_off()->moment;
        judge_.lift_off(*two_wheel_lift_.lift_off());
    }
}

void EventObserver::observe(const EcuOutput& output, double reception_time_s) {
    judge_.observe(output.state(), output.side(), reception_time_s);
    events_.judgement = judge_.judgement();
    if (output.state() != WarningState::warning || events_.warning) {
        return;
    }
    events_.warning =
        EventMoment{reception_time_s, latest_.lateral_acceleration_mps2, latest_.roll_angle_rad};
    events_.warning_side = output.side();
}

}  // namespace sil
