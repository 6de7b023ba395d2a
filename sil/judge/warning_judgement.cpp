#include "sil/judge/warning_judgement.hpp"

#include <algorithm>
#include <cmath>

namespace sil {

bool is_warned(const std::optional<double>& lead_s, double wanted_s) {
    return lead_s && *lead_s >= wanted_s - time_rounding_s;
}

LoadBand load_band(double largest_load_transfer_ratio) {
    if (largest_load_transfer_ratio < 0.7) {
        return LoadBand::below_0_7;
    }
    if (largest_load_transfer_ratio < 0.8) {
        return LoadBand::from_0_7;
    }
    return largest_load_transfer_ratio < 0.9 ? LoadBand::from_0_8 : LoadBand::from_0_9;
}

const char* to_string(LoadBand band) {
    switch (band) {
        case LoadBand::below_0_7:
            return "below 0.7";
        case LoadBand::from_0_7:
            return "0.7 to 0.8";
        case LoadBand::from_0_8:
            return "0.8 to 0.9";
        case LoadBand::from_0_9:
            return "0.9 to lift";
    }
    return "invalid";
}

void NamedWarnings::observe(WarningState state, WarningSide side, double time_s) {
    if (state != WarningState::warning) {
        in_force_ = false;
        return;
    }
    if (side != WarningSide::none && (!in_force_ || warnings_.back().side != side)) {
        warnings_.push_back({time_s, time_s, side});
        in_force_ = true;
    }
    if (in_force_) {
        warnings_.back().end_s = time_s;
    }
}

void WarningInForce::observe(WarningState state, WarningSide side, double time_s) {
    const WarningSide now = state == WarningState::warning ? side : WarningSide::none;
    if (now != side_) {
        side_ = now;
        since_s_ = time_s;
    }
}

std::optional<double> WarningInForce::lead_s(double lift_off_time_s, WarningSide falling_side) const {
    if (side_ == WarningSide::none || side_ != falling_side) {
        return std::nullopt;
    }
    // Not -1e-16 for a warning that comes in the very moment.
    return std::max(0.0, lift_off_time_s - since_s_);
}

void WarningJudge::observe(double time_s, double load_transfer_ratio) {
    if (first_time_s_) {
        count_time(time_s - time_s_, time_s_);
    } else {
        first_time_s_ = time_s;
        swung_s_ = time_s;
    }
    time_s_ = time_s;
    const WarningSide loaded = loaded_side(load_transfer_ratio);
    if (loaded != WarningSide::none && loaded != loaded_side_) {
        swing_to(loaded);
    }
    // std::fmax takes the number beside a NaN: a vehicle in the air has no load transfer.
    judgement_.largest_load_transfer_ratio =
        std::fmax(judgement_.largest_load_transfer_ratio, std::fabs(load_transfer_ratio));
}

// State of the step that begins there, until its end.
void WarningJudge::count_time(double step_s, double begin_s) {
    switch (state_) {
        case WarningState::unavailable:
            judgement_.unavailable_s +=
                started_ || begin_s >= *first_time_s_ + start_up_s - time_rounding_s ? step_s : 0.0;
            break;
        case WarningState::advisory:
            judgement_.advisory_s += step_s;
            break;
        case WarningState::warning:
            count_warning(step_s, begin_s);
            return;
        default:
            break;
    }
    wrong_until_now_s_ = 0.0;
}

void WarningJudge::count_warning(double step_s, double begin_s) {
    judgement_.warning_s += step_s;
    const bool wrong =
        side_ != WarningSide::none && loaded_side_ != WarningSide::none && side_ != loaded_side_;
    const bool settled = begin_s >= swung_s_ + swing_s - time_rounding_s;
    if (wrong && settled) {
        judgement_.wrong_side_s += step_s;
        wrong_until_now_s_ += step_s;
    } else {
        wrong_until_now_s_ = 0.0;
    }
}

void WarningJudge::swing_to(WarningSide side) {
    const bool foreseen = state_ == WarningState::warning && side_ == side;
    judgement_.wrong_side_s -= foreseen ? std::min(wrong_until_now_s_, foresight_s) : 0.0;
    wrong_until_now_s_ = 0.0;
    loaded_side_ = side;
    swung_s_ = time_s_;
}

void WarningJudge::observe(WarningState state, WarningSide side, double reception_time_s) {
    if (state == state_ && side == side_) {
        return;
    }
    judgement_.warnings += state == WarningState::warning && state_ != WarningState::warning ? 1U : 0U;
    judgement_.advisories +=
        state == WarningState::advisory && state_ != WarningState::advisory && state_ != WarningState::warning
            ? 1U
            : 0U;
    started_ = started_ || state != WarningState::unavailable;
    state_ = state;
    side_ = side;
    wrong_until_now_s_ = 0.0;
    changes_.push_back({reception_time_s, state, side});
    judgement_.late = judgement_.late || (judgement_.lifted && !judgement_.lead_s &&
                                          state == WarningState::warning && side == judgement_.falling_side);
}

void WarningJudge::lift_off(const TwoWheelLiftOff& lift_off) {
    const double time_s = lift_off.moment.time_s;
    WarningInForce in_force;
    bool later = false;
    for (const Change& change : changes_) {
        if (change.time_s <= time_s + time_rounding_s) {
            in_force.observe(change.state, change.side, change.time_s);
        } else {
            later = later || (change.state == WarningState::warning && change.side == lift_off.side);
        }
    }
    judgement_.lifted = true;
    judgement_.falling_side = lift_off.side;
    judgement_.side_at_lift_off = in_force.side();
    judgement_.lead_s = in_force.lead_s(time_s, lift_off.side);
    judgement_.late = !judgement_.lead_s && later;
}

}  // namespace sil
