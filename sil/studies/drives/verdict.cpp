#include "sil/studies/drives/verdict.hpp"

#include <algorithm>
#include <cmath>

namespace sil {
namespace {

Verdict of_a_lift_off(const WarningJudgement& judgement) {
    if (is_warned(judgement.lead_s)) {
        return Verdict::ahead;
    }
    if (judgement.side_at_lift_off != WarningSide::none) {
        return Verdict::wrong_side;
    }
    return judgement.late ? Verdict::late : Verdict::missed;
}

}  // namespace

// Axles that share the load transfer unevenly lift their first wheel earlier than at 0.9.
bool cannot_lift(const ReplayWarning& warning) {
    return load_band(warning.largest_load_transfer_ratio) == LoadBand::below_0_7;
}

Verdict verdict(const DriveReplay& replay) {
    const RunEvents& events = replay.events;
    if (events.judgement.lifted) {
        return of_a_lift_off(events.judgement);
    }
    const bool known = replay.lift_off.source != LiftOffSource::unknown;
    if (!events.warning) {
        if (events.judgement.unavailable_s > 0.0) {
            return Verdict::unavailable;
        }
        return known ? Verdict::quiet : Verdict::no_warning;
    }
    if (!known) {
        return std::any_of(replay.warnings.begin(), replay.warnings.end(), cannot_lift) ? Verdict::false_alarm
                                                                                        : Verdict::warning;
    }
    if (events.one_wheel_lift) {
        return Verdict::one_wheel_alarm;
    }
    const bool near = load_band(replay.largest_load_transfer_ratio) == LoadBand::from_0_9;
    return near && std::isfinite(replay.largest_load_transfer_ratio) ? Verdict::near_alarm
                                                                     : Verdict::false_alarm;
}

const char* to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::ahead:
            return "ahead";
        case Verdict::wrong_side:
            return "wrong side";
        case Verdict::late:
            return "late";
        case Verdict::missed:
            return "missed";
        case Verdict::one_wheel_alarm:
            return "one-wheel alarm";
        case Verdict::near_alarm:
            return "near alarm";
        case Verdict::false_alarm:
            return "false alarm";
        case Verdict::unavailable:
            return "unavailable";
        case Verdict::quiet:
            return "quiet";
        case Verdict::warning:
            return "warning";
        case Verdict::no_warning:
            return "no warning";
    }
    return "invalid";
}

}  // namespace sil
