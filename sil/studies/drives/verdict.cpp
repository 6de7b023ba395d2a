#include "sil/studies/drives/verdict.hpp"

namespace sil {
namespace {

constexpr double near_lift_ratio = 0.9;

}  // namespace

Verdict verdict(const DriveReplay& replay) {
    const RunEvents& events = replay.events;
    if (replay.lift_off.source == LiftOffSource::unknown) {
        return events.warning ? Verdict::warning : Verdict::no_warning;
    }
    if (events.two_wheel_lift) {
        if (!events.warning) {
            return Verdict::missed;
        }
        return events.warning->time_s < events.two_wheel_lift->time_s ? Verdict::ahead : Verdict::late;
    }
    if (!events.warning) {
        return Verdict::quiet;
    }
    if (events.one_wheel_lift) {
        return Verdict::one_wheel_alarm;
    }
    return replay.largest_load_transfer_ratio >= near_lift_ratio ? Verdict::near_alarm : Verdict::false_alarm;
}

const char* to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::ahead:
            return "ahead";
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
