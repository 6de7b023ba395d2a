// The table of expectations: first the kind of fault, then the place.
#include "sil/faults/expectation.hpp"

#include <array>

namespace sil {
namespace {

constexpr int at_once_ms = 50;  // the frame itself shows that something is wrong
// What only a comparison over some time shows.
constexpr int roll_debounce_ms = 350;
constexpr int debounce_ms = 500;
constexpr int vertical_offset_debounce_ms = 700;
constexpr int roll_rate_offset_debounce_ms = 1000;
constexpr int yaw_sign_debounce_ms = 1300;

// From the end of the fault to the right statement, and to the last code's healing.
constexpr int recovery_of_frames_ms = 250;
constexpr int recovery_of_values_ms = 3000;
constexpr int healing_ms = 1500;
constexpr int warning_hold_ms = 2000;  // warning_hold_s of the calibration

constexpr Expectation nothing{Demand::unaffected, 0, at_once_ms, healing_ms};

// What can be seen at once, and is gone with the fault.
constexpr Expectation at_once(Demand demand) {
    return {demand, at_once_ms, recovery_of_frames_ms, healing_ms};
}

// What must follow when nothing usable comes from there.
Demand demand_of_loss(FaultPlace place) {
    switch (place) {
        case FaultPlace::lateral_acceleration:
        case FaultPlace::roll_rate:
        case FaultPlace::imu_frame:
        case FaultPlace::all_sensor_frames:
            return Demand::unavailable;
        case FaultPlace::roll_angle:
        case FaultPlace::roll_angle_frame:
            return Demand::roll_sensor_lost;
        case FaultPlace::speed:
        case FaultPlace::yaw_rate:
        case FaultPlace::vehicle_motion_frame:
            return Demand::motion_lost;
        default:
            return Demand::usable;
    }
}

// Nothing else in the vehicle says what these say, and the warning hardly needs them.
bool is_optional(FaultPlace place) {
    return place == FaultPlace::bank_angle || place == FaultPlace::steering_wheel_angle;
}

// The stated debounces (docs/safety/degradation.md).
int debounce_of(const Fault& fault) {
    if (fault.place == FaultPlace::vertical_acceleration && fault.kind != FaultKind::noise) {
        return vertical_offset_debounce_ms;
    }
    if (fault.place == FaultPlace::roll_rate && fault.kind != FaultKind::noise) {
        return roll_rate_offset_debounce_ms;
    }
    if (fault.place == FaultPlace::yaw_rate && fault.kind == FaultKind::sign_flip) {
        return yaw_sign_debounce_ms;
    }
    return fault.place == FaultPlace::roll_angle ? roll_debounce_ms : debounce_ms;
}

// What shows whatever the vehicle does. The others show only where something moves, or are for a while too
// small to be told from the road: then nothing need be said as long as the warning does not suffer.
bool always_shows(const Fault& fault) {
    switch (fault.kind) {
        case FaultKind::noise:
            return true;
        case FaultKind::offset:
            return fault.place == FaultPlace::vertical_acceleration || fault.place == FaultPlace::roll_rate ||
                   fault.place == FaultPlace::roll_angle || fault.place == FaultPlace::speed;
        case FaultKind::sign_flip:
            return fault.place == FaultPlace::vertical_acceleration;
        default:
            return false;
    }
}

Expectation contradiction(const Fault& fault) {
    const Demand demand = always_shows(fault) ? Demand::reported : Demand::kept_or_reported;
    return {is_optional(fault.place) ? Demand::right_or_reported : demand, debounce_of(fault),
            recovery_of_values_ms, recovery_of_values_ms};
}

}  // namespace

Expectation expectation_of(const Fault& fault) {
    switch (fault.kind) {
        case FaultKind::none:
            return {};
        case FaultKind::frozen:
        case FaultKind::offset:
        case FaultKind::drift:
        case FaultKind::noise:
        case FaultKind::sign_flip:
            return contradiction(fault);
        case FaultKind::saturated:
            return {demand_of_loss(fault.place), at_once_ms, recovery_of_values_ms, recovery_of_values_ms};
        case FaultKind::not_available:
            if (fault.place == FaultPlace::bank_angle) {  // as in most vehicles, which have no such sensor
                return nothing;
            }
            return at_once(demand_of_loss(fault.place));
        case FaultKind::out_of_range:
        case FaultKind::lost:
        case FaultKind::bad_crc:
        case FaultKind::counter_stands:
        case FaultKind::counter_jumps:
        case FaultKind::wrong_length:
            return at_once(demand_of_loss(fault.place));
        case FaultKind::delayed:
            return fault.magnitude > 30.0 ? at_once(demand_of_loss(fault.place)) : nothing;
        case FaultKind::swapped:
            // Two frames are lost: Imu among them, or RollAngle and VehicleMotion, without which no roll
            // angle is known.
            return at_once(Demand::unavailable);
        case FaultKind::doubled:
        case FaultKind::error_passive:
            return at_once(Demand::usable);
        case FaultKind::flood_foreign:  // up to what the bus can carry, all of it is read in a cycle
            return fault.magnitude < 50.0 ? nothing : at_once(Demand::reported);
        case FaultKind::flood_own:
            return at_once(Demand::reported);
        case FaultKind::bus_off:
            return at_once(Demand::reported);
        case FaultKind::clock_jump:
            return at_once(Demand::reported);
        case FaultKind::process_stop:
            return fault.magnitude > 30.0 ? at_once(Demand::unavailable) : at_once(Demand::usable);
    }
    return {};
}

int longest_false_warning_ms(const Expectation& expectation) {
    return expectation.reaction_ms + warning_hold_ms;
}

const char* to_string(Demand demand) {
    constexpr std::array names{"no change",
                               "right, or code",
                               "warning kept, or code",
                               "code",
                               "code, usable",
                               "code, roll from the observer",
                               "code, motion lost",
                               "code, unavailable"};
    return names[static_cast<std::size_t>(demand)];
}

}  // namespace sil
