#include "sil/studies/drives/lift_off.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sil/judge/two_wheel_lift.hpp"

namespace sil {
namespace {

constexpr double lifted_share = 0.01;

double sum_of_loads(const DriveSample& sample) {
    return sample.wheel_load_n[front_left] + sample.wheel_load_n[front_right] +
           sample.wheel_load_n[rear_left] + sample.wheel_load_n[rear_right];
}

// NaN without wheel loads.
double static_wheel_load_n(const Drive& drive) {
    std::vector<double> sums_n;
    for (const DriveSample& sample : drive.samples) {
        const double sum_n = sum_of_loads(sample);
        const bool is_early = sample.time_s <= drive.samples.front().time_s + upright_time_s;
        if (!std::isnan(sum_n) && (is_early || sums_n.empty())) {
            sums_n.push_back(sum_n);
        }
    }
    if (sums_n.empty()) {
        return DriveSample::not_available;
    }
    const auto middle = sums_n.begin() + static_cast<std::ptrdiff_t>(sums_n.size() / 2U);
    std::nth_element(sums_n.begin(), middle, sums_n.end());
    return *middle / wheel_count;
}

// By the loads at the given time, if there are any.
WarningSide given_side(const Drive& drive) {
    WarningSide side = WarningSide::none;
    for (const DriveSample& sample : drive.samples) {
        if (!drive.two_wheel_lift_s || sample.time_s > *drive.two_wheel_lift_s + time_rounding_s) {
            break;
        }
        const WarningSide loaded = loaded_side(load_transfer_ratio(sample));
        side = loaded == WarningSide::none ? side : loaded;
    }
    return side;
}

}  // namespace

const char* to_string(LiftOffSource source) {
    switch (source) {
        case LiftOffSource::unknown:
            return "unknown";
        case LiftOffSource::given:
            return "given";
        case LiftOffSource::wheel_loads:
            return "wheel loads";
    }
    return "invalid";
}

LiftOff find_lift_off(const Drive& drive) {
    if (drive.lift_off_given) {
        return {LiftOffSource::given, drive.one_wheel_lift_s, drive.two_wheel_lift_s, given_side(drive), 0.0};
    }
    const double threshold_n = lifted_share * static_wheel_load_n(drive);
    if (std::isnan(threshold_n)) {
        return {};
    }
    LiftOff result{LiftOffSource::wheel_loads, {}, {}, {}, threshold_n};
    TwoWheelLiftObserver two_wheels;
    for (const DriveSample& sample : drive.samples) {
        const auto lifted = [&](std::size_t wheel) { return sample.wheel_load_n[wheel] < threshold_n; };
        const bool left_front = lifted(front_left), right_front = lifted(front_right);
        const bool left_rear = lifted(rear_left), right_rear = lifted(rear_right);
        if (!result.one_wheel_s && (left_front || right_front || left_rear || right_rear)) {
            result.one_wheel_s = sample.time_s;
        }
        two_wheels.observe({sample.time_s, sample.lateral_acceleration_mps2, sample.roll_angle_rad},
                           left_front && left_rear, right_front && right_rear);
    }
    if (two_wheels.lift_off()) {
        result.two_wheel_s = two_wheels.lift_off()->moment.time_s;
        result.falling_side = two_wheels.lift_off()->side;
    }
    return result;
}

double load_transfer_ratio(const DriveSample& sample) {
    const double right_n = sample.wheel_load_n[front_right] + sample.wheel_load_n[rear_right];
    const double left_n = sample.wheel_load_n[front_left] + sample.wheel_load_n[rear_left];
    return right_n + left_n > 0.0 ? (right_n - left_n) / (right_n + left_n) : DriveSample::not_available;
}

}  // namespace sil
