// The table of expectations: first the kind of fault, then the place.
#include "sil/studies/faults/expectation.hpp"

#include <algorithm>
#include <array>

#include "sil/studies/faults/contradiction.hpp"
#include "sil/studies/faults/known_undetected.hpp"

namespace sil {
namespace {

constexpr int at_once_ms = 50;  // the frame itself shows that something is wrong
constexpr int wrong_ms = 110;
constexpr int forecast_lead_ms = 50;   // added to the lead of a warning by yaw rate, speed and steering
constexpr int warning_hold_ms = 1000;  // warning_hold_s of the calibration, from the last sample at its level
constexpr int fading_ms = 50;          // until the filters of the prediction have lost a wrong value

// From the end of the fault to the right statement, and to the last code's healing.
struct Return {
    int recovery_ms;
    int healing_ms;
};
constexpr Return of_frames{150, 1100};       // channel, recovery_s; 100 cycles
constexpr Return of_values{150, 50};         // 5 cycles, recovery_s
constexpr Return of_saturation{1000, 1050};  // the jump back, the observer's second

// A lost speed or yaw rate takes from the forecast what it looks ahead by.
constexpr int lead_loss_of(Demand demand) {
    return longest_lead_loss_ms + (demand == Demand::motion_lost ? forecast_lead_ms : 0);
}

constexpr Expectation nothing{Demand::unaffected,   0,        of_frames.recovery_ms,
                              of_frames.healing_ms, wrong_ms, longest_lead_loss_ms};

// Effects that are visible at once, and gone with the fault.
constexpr Expectation at_once(Demand demand, int lapse_ms = 0, Return back = of_frames) {
    return {demand, at_once_ms, back.recovery_ms, back.healing_ms, wrong_ms, lead_loss_of(demand), lapse_ms};
}

// Reactions required when nothing usable comes from there.
Demand demand_of_loss(FaultPlace place) {
    switch (place) {
        case FaultPlace::lateral_acceleration:
        case FaultPlace::roll_rate:
        case FaultPlace::imu_frame:
        case FaultPlace::all_sensor_frames:
        case FaultPlace::inertial_signals:
        case FaultPlace::all_signals:
            return Demand::unavailable;
        case FaultPlace::roll_angle:
        case FaultPlace::roll_angle_frame:
            return Demand::roll_sensor_lost;
        case FaultPlace::speed:
        case FaultPlace::yaw_rate:
        case FaultPlace::vehicle_motion_frame:
        case FaultPlace::motion_signals:
            return Demand::motion_lost;
        default:
            return Demand::usable;
    }
}

// After a value that contradicted others: what had to be good without a break, and filters that have to
// settle.
Return return_from(FaultKind kind, SceneKind scene) {
    switch (kind) {
        case FaultKind::frozen:
            if (scene == SceneKind::over) {  // back to a value that has moved on: a jump
                return of_saturation;
            }
            return {300, 250};
        case FaultKind::noise:
            return {1000, 1050};
        case FaultKind::offset:
        case FaultKind::drift:
            return {1300, 1200};
        default:
            return {1550, 1650};
    }
}

// If it shows, the lost signal is invalidated; the warning suffers no longer than the debounce takes.
// Otherwise it must have no effect.
Expectation contradiction(const Fault& fault, SceneKind scene) {
    const Contradiction& stated = contradiction_of(fault);
    const int limit_ms = limit_of(stated, scene);
    const Return back = return_from(fault.kind, scene);
    if (limit_ms == hidden) {
        return {Demand::right,  0,          back.recovery_ms, back.healing_ms, stated.wrong_ms,
                stated.late_ms, any_time_ms};
    }
    Expectation expected{demand_of_loss(fault.place), limit_ms, back.recovery_ms, back.healing_ms};
    expected.wrong_ms = std::max({limit_ms, wrong_ms, stated.wrong_ms});
    expected.lead_loss_ms = expected.demand == Demand::motion_lost ? limit_ms + lead_loss_of(expected.demand)
                                                                   : std::max(limit_ms, longest_lead_loss_ms);
    expected.lapse_ms = stated.lapse_ms;
    return expected;
}

// Its place and time are not stated yet: the ECU's answer counts.
Expectation right_or_reported(FaultKind kind, SceneKind scene) {
    const Return back = return_from(kind, scene);
    return {Demand::right, 0, back.recovery_ms, back.healing_ms, wrong_ms, longest_lead_loss_ms, any_time_ms};
}

// For the other two frames only the silence at its beginning shows; then the statement comes late.
Expectation delay(FaultPlace place) {
    Expectation expected =
        at_once(demand_of_loss(place), place == FaultPlace::roll_angle_frame ? 0 : any_time_ms);
    expected.wrong_ms = wrong_ms + at_once_ms;
    return expected;
}

// No place of a scene moves these so that a time could be stated.
bool has_no_stated_time(FaultPlace place) {
    return place == FaultPlace::vehicle_mass || place >= FaultPlace::inertial_signals;
}

Expectation expectation_while_there(const Fault& fault, SceneKind scene) {
    if (has_no_stated_time(fault.place) &&
        (fault.kind <= FaultKind::sign_flip && fault.kind > FaultKind::none)) {
        return right_or_reported(fault.kind, scene);
    }
    switch (fault.kind) {
        case FaultKind::none:
            return {};
        case FaultKind::frozen:
        case FaultKind::offset:
        case FaultKind::drift:
        case FaultKind::noise:
        case FaultKind::sign_flip:
            return contradiction(fault, scene);
        case FaultKind::gain:
        case FaultKind::noise_alone:
            return right_or_reported(fault.kind, scene);
        case FaultKind::saturated:
            return at_once(demand_of_loss(fault.place), 0, of_saturation);
        case FaultKind::not_available:
            if (fault.place == FaultPlace::bank_angle ||
                fault.place == FaultPlace::vehicle_mass) {  // as in most vehicles, which have no such sensor
                return nothing;
            }
            return at_once(demand_of_loss(fault.place), 0, of_values);
        case FaultKind::out_of_range:
            return at_once(demand_of_loss(fault.place), 0, of_values);
        case FaultKind::lost:
        case FaultKind::bad_crc:
        case FaultKind::counter_stands:
        case FaultKind::counter_jumps:
        case FaultKind::wrong_length:
            return at_once(demand_of_loss(fault.place));
        case FaultKind::delayed:
            return fault.magnitude > 30.0 ? delay(fault.place) : nothing;
        case FaultKind::swapped:
            // Two frames are lost: Imu among them, or RollAngle and VehicleMotion, without which no roll
            // angle is known.
            return at_once(Demand::unavailable);
        case FaultKind::sender_before:
        case FaultKind::sender_after:
        case FaultKind::sender_tenfold:
            return at_once(fault.place == FaultPlace::warning_frame ? Demand::reported
                                                                    : demand_of_loss(fault.place));
        case FaultKind::doubled:
        case FaultKind::error_passive:
            return at_once(Demand::usable);
        case FaultKind::flood_foreign:  // up to what the bus can carry, all of it is read in a cycle
            return fault.magnitude < 50.0 ? nothing : at_once(Demand::reported);
        case FaultKind::flood_own:
            return at_once(Demand::unavailable);
        case FaultKind::bus_off:
        case FaultKind::clock_jump:
            return at_once(Demand::unavailable, any_time_ms);
        case FaultKind::turned_about_x:
        case FaultKind::turned_about_z:
            return right_or_reported(fault.kind, scene);
        case FaultKind::process_stop:
            return at_once(fault.magnitude > 30.0 ? Demand::unavailable : Demand::usable, any_time_ms);
    }
    return {};
}

// The fault is over before the warning is due, so that the ECU may or may not have found it. It is back in
// time for the warning, or after it by no more than its recovery takes.
Expectation expectation_of_recovery(const Expectation& there) {
    Expectation expected = there;
    if (there.demand == Demand::unaffected || there.demand == Demand::right) {
        return expected;
    }
    expected.demand = Demand::recovery;
    expected.lead_loss_ms =
        std::max(there.recovery_ms - over_before_warning_ms, 0) + lead_loss_of(there.demand);
    return expected;
}

bool ends_as_the_scene_says(const Fault& fault) {
    return fault.kind != FaultKind::clock_jump && fault.kind != FaultKind::process_stop;
}

}  // namespace

Expectation expectation_of(const Fault& fault, SceneKind scene) {
    Expectation expected = expectation_while_there(fault, scene);
    if (scene == SceneKind::over && ends_as_the_scene_says(fault)) {
        expected = expectation_of_recovery(expected);
    }
    expected.known_undetected = is_known_undetected(fault) && scene >= SceneKind::before_turn;
    return expected;
}

int longest_false_warning_ms(const Expectation& expectation) {
    return expectation.demand == Demand::unaffected || expectation.demand == Demand::right
               ? 0
               : expectation.reaction_ms + fading_ms + warning_hold_ms;
}

const char* to_string(Demand demand) {
    constexpr std::array names{"recovery",
                               "no change",
                               "right",
                               "code",
                               "code, usable",
                               "code, roll from the observer",
                               "code, motion lost",
                               "code, unavailable"};
    return names[static_cast<std::size_t>(demand)];
}

}  // namespace sil
