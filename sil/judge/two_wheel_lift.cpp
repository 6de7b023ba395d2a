#include "sil/judge/two_wheel_lift.hpp"

namespace sil {

WarningSide loaded_side(double load_transfer_or_acceleration) {
    if (load_transfer_or_acceleration > 0.0) {
        return WarningSide::right;
    }
    return load_transfer_or_acceleration < 0.0 ? WarningSide::left : WarningSide::none;
}

void TwoWheelLiftObserver::observe(const EventMoment& now, bool left_up, bool right_up) {
    if (lift_off_) {
        return;
    }
    follow(left_began_, now, left_up);
    follow(right_began_, now, right_up);
    const bool left_lasts = lasts(left_began_, now);
    const bool right_lasts = lasts(right_began_, now);
    if (left_lasts && right_lasts) {
        lift_off_ = TwoWheelLiftOff{*left_began_, loaded_side(left_began_->lateral_acceleration_mps2)};
    } else if (left_lasts) {
        lift_off_ = TwoWheelLiftOff{*left_began_, WarningSide::right};
    } else if (right_lasts) {
        lift_off_ = TwoWheelLiftOff{*right_began_, WarningSide::left};
    }
}

void TwoWheelLiftObserver::follow(std::optional<EventMoment>& began, const EventMoment& now, bool up) {
    if (up && !began) {
        began = now;
    } else if (!up && began) {
        if (!brief_time_s_) {
            brief_time_s_ = began->time_s;
        }
        began.reset();
    }
}

bool TwoWheelLiftObserver::lasts(const std::optional<EventMoment>& began, const EventMoment& now) const {
    return began && now.time_s - began->time_s >= lasting_s - time_rounding_s;
}

std::optional<double> TwoWheelLiftObserver::brief_time_s() const {
    if (lift_off_ || brief_time_s_) {
        return brief_time_s_;
    }
    const std::optional<EventMoment>& began = left_began_ ? left_began_ : right_began_;
    return began ? std::optional<double>{began->time_s} : std::nullopt;
}

}  // namespace sil
