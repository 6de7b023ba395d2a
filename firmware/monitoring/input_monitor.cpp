#include "monitoring/input_monitor.hpp"

#include "rsi/numeric/bounded.hpp"

namespace monitoring {
namespace {

// Of the observer: reliable again within half of what the component's own check tolerates.
constexpr float agreement_rad = 0.025F;

// No road is as steep (45 %, several times what is built), and the sensor ends at 0.785 rad.
constexpr float steepest_bank_rad = 0.42F;

// The body leans out of the turn; below this the sign of the force says nothing.
constexpr float clear_force_mps2 = 2.0F;

constexpr float sure_excess_deviation = 0.06F;

// Of the road: measured, or as the observer has it.
float known_bank_rad(const rsi::Inputs& inputs, const rsi::Outputs& before) noexcept {
    const bool measured = rsi::is_within_magnitude(inputs.bank_angle_rad, steepest_bank_rad);
    return measured ? inputs.bank_angle_rad : before.observed_bank_angle_rad;
}

// What minutes of driving have shown. An accelerometer that has just failed looks like a load, but not like
// one that is known so well. NaN while the component makes no statement.
float sure_load_excess(const rsi::Outputs& before) noexcept {
    return (before.load_excess_deviation >= sure_excess_deviation) ? 0.0F : before.load_excess;
}

// Of the body against the horizon: what the lateral force is more than the turn needs, as a component of
// gravity. It takes a slide for an inclination, and so is no proof of one.
float inclination_rad(const rsi::Inputs& inputs) noexcept {
    constexpr float per_gravity = 1.0F / rsi::gravity_mps2;
    const float sine =
        (inputs.lateral_specific_force_mps2 - inputs.yaw_rate_radps * inputs.speed_mps) * per_gravity;
    return rsi::is_within_magnitude(sine, 0.5F) ? sine * (1.0F + sine * sine * (1.0F / 6.0F))
                                                : rsi::not_available;
}

bool either_confirmed(const DiagnosticMemory& memory, DiagnosticCode a, DiagnosticCode b) noexcept {
    return memory.confirmed(a) || memory.confirmed(b);
}

// Roll rate and roll angle, each other.
bool roll_contradicts(const DiagnosticMemory& memory) noexcept {
    return either_confirmed(memory, DiagnosticCode::roll_rate_contradicts_roll_angle,
                            DiagnosticCode::roll_rate_offset);
}

// Seen, if only once.
bool suspected(const DiagnosticMemory& memory, DiagnosticCode code) noexcept {
    const EventStatus status = memory.status(code);
    return (status == EventStatus::set) || (status == EventStatus::confirmed);
}

// The value, or NaN when it fails by itself: then it says nothing of the others.
float trusted(float value, const DiagnosticMemory& memory, DiagnosticCode invalid,
              DiagnosticCode jump) noexcept {
    return (suspected(memory, invalid) || suspected(memory, jump)) ? rsi::not_available : value;
}

rsi::Inputs witnesses(const rsi::Inputs& inputs, const DiagnosticMemory& memory) noexcept {
    rsi::Inputs kept = inputs;
    kept.lateral_specific_force_mps2 =
        trusted(inputs.lateral_specific_force_mps2, memory, DiagnosticCode::lateral_acceleration_invalid,
                DiagnosticCode::lateral_acceleration_jump);
    kept.roll_rate_radps = trusted(inputs.roll_rate_radps, memory, DiagnosticCode::roll_rate_invalid,
                                   DiagnosticCode::roll_rate_jump);
    kept.roll_angle_rad = trusted(inputs.roll_angle_rad, memory, DiagnosticCode::roll_angle_invalid,
                                  DiagnosticCode::roll_angle_jump);
    kept.yaw_rate_radps = trusted(inputs.yaw_rate_radps, memory, DiagnosticCode::yaw_rate_invalid,
                                  DiagnosticCode::yaw_rate_jump);
    kept.speed_mps =
        trusted(inputs.speed_mps, memory, DiagnosticCode::speed_invalid, DiagnosticCode::speed_jump);
    kept.vertical_specific_force_mps2 =
        trusted(inputs.vertical_specific_force_mps2, memory, DiagnosticCode::vertical_acceleration_invalid,
                DiagnosticCode::vertical_acceleration_jump);
    kept.steering_wheel_angle_rad = trusted(inputs.steering_wheel_angle_rad, memory,
                                            DiagnosticCode::steering_invalid, DiagnosticCode::steering_jump);
    return kept;
}

}  // namespace

void InputMonitor::start(const rsi::Parameters& parameters) noexcept {
    const bool roll_rate_is_wrong = roll_rate_is_wrong_;  // the code outlives a stall, and so must the blame
    *this = InputMonitor{};
    roll_rate_is_wrong_ = roll_rate_is_wrong;
    against_horizon_ = (parameters.roll_angle_reference == RSI_ROLL_AGAINST_HORIZON);
    roll_reference_.start(parameters);
    force_vote_.start(parameters);
}

rsi::Inputs InputMonitor::qualify(const rsi::Inputs& inputs, const FreshFrames& fresh,
                                  const rsi::Outputs& before, DiagnosticMemory& memory) noexcept {
    rsi::Inputs qualified = check_each(inputs, fresh, memory);
    const rsi::Inputs kept = memory.no_active_codes() ? inputs : witnesses(inputs, memory);
    check_stuck(kept, memory);
    check_roll(kept, fresh.late_roll_angle_rad, memory);
    check_vertical(kept, before, memory);
    check_turn(kept, before, memory);
    check_reference(kept, before, memory);
    check_observer(inputs, before, memory);
    if (!memory.no_active_codes()) {
        invalidate_confirmed(qualified, memory);
    }
    return qualified;
}

// A frame that is lost has its own code; its signals are not judged.
rsi::Inputs InputMonitor::check_each(const rsi::Inputs& inputs, const FreshFrames& fresh,
                                     DiagnosticMemory& memory) noexcept {
    rsi::Inputs qualified = inputs;
    if (fresh.imu) {
        qualified.lateral_specific_force_mps2 = lateral_.qualify(inputs.lateral_specific_force_mps2, memory);
        qualified.vertical_specific_force_mps2 =
            vertical_.qualify(inputs.vertical_specific_force_mps2, memory);
        qualified.roll_rate_radps = roll_rate_.qualify(inputs.roll_rate_radps, memory);
    } else {
        lateral_.forget();
        vertical_.forget();
        roll_rate_.forget();
    }
    if (fresh.roll_angle) {
        const float turned =
            rsi::is_finite(qualified.roll_rate_radps) ? rsi::sample_time_s * qualified.roll_rate_radps : 0.0F;
        qualified.roll_angle_rad = roll_angle_.qualify(inputs.roll_angle_rad, memory, turned);
        // Most vehicles have no bank sensor.
        memory.report(DiagnosticCode::bank_angle_invalid,
                      rsi::is_finite(inputs.bank_angle_rad) &&
                          !rsi::is_within_magnitude(inputs.bank_angle_rad, steepest_bank_rad));
    } else {
        roll_angle_.forget();
    }
    if (fresh.vehicle_motion) {
        qualified.yaw_rate_radps = yaw_rate_.qualify(inputs.yaw_rate_radps, memory);
        qualified.speed_mps = speed_.qualify(inputs.speed_mps, memory);
        qualified.steering_wheel_angle_rad = steering_.qualify(inputs.steering_wheel_angle_rad, memory);
    } else {
        yaw_rate_.forget();
        speed_.forget();
        steering_.forget();
    }
    return qualified;
}

void InputMonitor::check_stuck(const rsi::Inputs& inputs, DiagnosticMemory& memory) noexcept {
    const float turn = inputs.yaw_rate_radps * inputs.speed_mps;
    const float lateral = inputs.lateral_specific_force_mps2;
    // NaN when it begins anew: no witness has jumped then.
    const float sum = turned_rad_ + rsi::sample_time_s * inputs.roll_rate_radps;
    const float turned = rsi::is_within_magnitude(sum, 5.0F) ? sum : rsi::not_available;
    turned_rad_ = rsi::is_finite(turned) ? turned : 0.0F;
    const auto report = [&memory](DiagnosticCode code, auto& check, auto... signals) noexcept {
        const bool stuck = check.is_stuck(signals...);
        // An inactive or missing witness does not clear a value that repeats itself.
        if (stuck || check.moves()) {
            memory.report(code, stuck);
        }
    };
    report(DiagnosticCode::lateral_acceleration_stuck, lateral_stuck_, lateral, turn);
    report(DiagnosticCode::vertical_acceleration_stuck, vertical_stuck_, inputs.vertical_specific_force_mps2,
           lateral);
    report(DiagnosticCode::roll_rate_stuck, roll_rate_stuck_, inputs.roll_rate_radps,
           inputs.roll_angle_rad - turned);
    report(DiagnosticCode::roll_angle_stuck, roll_angle_stuck_, inputs.roll_angle_rad, turned);
    report(DiagnosticCode::yaw_rate_stuck, yaw_rate_stuck_, inputs.yaw_rate_radps, lateral);
    report(DiagnosticCode::speed_stuck, speed_stuck_, inputs.speed_mps, turn);
    report(DiagnosticCode::steering_stuck, steering_stuck_, inputs.steering_wheel_angle_rad, lateral, turn);
}

// An angle that is held back cannot confirm a contradiction, but only with it can one heal.
void InputMonitor::check_roll(const rsi::Inputs& inputs, float late_roll_angle_rad,
                              DiagnosticMemory& memory) noexcept {
    const bool before = roll_contradicts(memory);
    const bool only_heals = before && !rsi::is_finite(inputs.roll_angle_rad);
    roll_consistency_.update(only_heals ? late_roll_angle_rad : inputs.roll_angle_rad, inputs.roll_rate_radps,
                             inclination_rad(inputs));
    if (!roll_consistency_.known()) {
        return;
    }
    // Of an angle that does not fit the force the sensor is to blame, not the road.
    const bool may_twist = force_vote_.roll_motion_agrees();
    memory.report(DiagnosticCode::roll_rate_contradicts_roll_angle, roll_consistency_.contradicts(may_twist));
    memory.report(DiagnosticCode::roll_rate_offset, roll_consistency_.has_offset(may_twist));
    if (roll_contradicts(memory) && !before) {
        roll_rate_is_wrong_ = !roll_angle_is_wrong(inputs);
    }
}

// Which of the two is wrong: one that repeats itself; else the angle if the body
// seems to lean into the turn; else the rate, without which there is no statement.
bool InputMonitor::roll_angle_is_wrong(const rsi::Inputs& inputs) const noexcept {
    if (roll_angle_stuck_.seems_frozen() != roll_rate_stuck_.seems_frozen()) {
        return roll_angle_stuck_.seems_frozen();
    }
    const float force = inputs.lateral_specific_force_mps2;
    return !rsi::is_within_magnitude(force, clear_force_mps2) && (force * roll_against_road(inputs) < 0.0F);
}

// In a warning wheels lift and come down: nothing is confirmed or cleared meanwhile. The force depends so
// little on the roll angle that the observer's will do where the sensor's contains a bank.
void InputMonitor::check_vertical(const rsi::Inputs& inputs, const rsi::Outputs& before,
                                  DiagnosticMemory& memory) noexcept {
    vertical_offset_.update(inputs.vertical_specific_force_mps2, inputs.lateral_specific_force_mps2,
                            against_horizon_ ? before.observed_roll_angle_rad : inputs.roll_angle_rad);
    if (vertical_offset_.known()) {
        constexpr DiagnosticCode code = DiagnosticCode::vertical_acceleration_offset;
        const bool calm = (before.state == RSI_STATE_READY) || (before.state == RSI_STATE_ADVISORY);
        memory.report(code, vertical_offset_.has_offset(!calm && !memory.confirmed(code)));
    }
}

void InputMonitor::check_turn(const rsi::Inputs& inputs, const rsi::Outputs& before,
                              DiagnosticMemory& memory) noexcept {
    constexpr DiagnosticCode yaw_rate = DiagnosticCode::yaw_rate_contradicts_lateral_acceleration;
    constexpr DiagnosticCode lateral = DiagnosticCode::lateral_acceleration_contradicts_yaw_rate;
    turn_consistency_.update(inputs.lateral_specific_force_mps2, inputs.yaw_rate_radps, inputs.speed_mps);
    const float yaw_acceleration =
        turn_consistency_.known() ? inputs.yaw_rate_radps * inputs.speed_mps : rsi::not_available;
    rsi::Inputs against_road = inputs;
    against_road.roll_angle_rad = roll_against_road(inputs);
    turn_signs_.update(inputs.lateral_specific_force_mps2, yaw_acceleration, against_road.roll_angle_rad);
    force_vote_.assume_load(sure_load_excess(before));
    force_vote_.update(against_road, turn_consistency_.known() && !turn_consistency_.spins());
    if (!turn_consistency_.known()) {
        // Too slow to confirm a fault, but a vehicle at rest must be able to clear one.
        if (turn_consistency_.agrees()) {
            memory.report(yaw_rate, false);
            memory.report(lateral, false);
        }
        return;
    }
    memory.report(yaw_rate, memory.confirmed(yaw_rate)
                                ? !turn_consistency_.agrees()
                                : (turn_consistency_.contradicts() || turn_signs_.yaw_rate_is_alone()));
    const bool alone = turn_signs_.lateral_acceleration_is_alone() || force_vote_.accelerometer_is_alone();
    // While the yaw rate alone contradicts, as in a weave near the limit, neither good nor bad is shown.
    const bool good = turn_consistency_.agrees() && !alone;
    if (alone || (memory.confirmed(lateral) && (good || !force_vote_.roll_motion_agrees()))) {
        memory.report(lateral, !good);
    }
}

// The angle against the road that is a witness against the other sensors. One against the horizon needs the
// bank of a sensor: the observer's is made of the very signals that are to be checked.
float InputMonitor::roll_against_road(const rsi::Inputs& inputs) const noexcept {
    return against_horizon_ ? inputs.roll_angle_rad - inputs.bank_angle_rad : inputs.roll_angle_rad;
}

// What the sensor shows beyond the roll angle that the observer finds without it.
float InputMonitor::roll_beyond_observed(const rsi::Inputs& inputs,
                                         const rsi::Outputs& before) const noexcept {
    const float beyond_road = inputs.roll_angle_rad - before.observed_roll_angle_rad;
    return against_horizon_ ? beyond_road - known_bank_rad(inputs, before) : beyond_road;
}

// A wrong calibration does not show on a level road; once it has shown, no angle is what it is taken for.
void InputMonitor::check_reference(const rsi::Inputs& inputs, const rsi::Outputs& before,
                                   DiagnosticMemory& memory) noexcept {
    roll_reference_.update(inputs.roll_angle_rad, before.observed_roll_angle_rad,
                           known_bank_rad(inputs, before));
    if (roll_reference_.known()) {
        memory.report(DiagnosticCode::roll_angle_reference_wrong, roll_reference_.contradicts());
    }
}

// The observer makes the roll angle of the lateral force and the roll rate. Where it contradicts the roll
// sensor, one of the sensors is wrong: the accelerometer, if it contradicts the yaw rate too, else the
// roll sensor. The component's own check, confirmed for 0.3 s, decides when the observer is reliable.
void InputMonitor::check_observer(const rsi::Inputs& inputs, const rsi::Outputs& before,
                                  DiagnosticMemory& memory) noexcept {
    constexpr DiagnosticCode roll_sensor = DiagnosticCode::roll_sensor_contradicts_observer;
    constexpr DiagnosticCode lateral = DiagnosticCode::lateral_acceleration_contradicts_yaw_rate;
    const float difference = roll_beyond_observed(inputs, before);
    if (memory.confirmed(roll_sensor)) {
        if (rsi::is_finite(difference)) {
            memory.report(roll_sensor, !rsi::is_within_magnitude(difference, agreement_rad));
        }
        return;
    }
    if (turn_consistency_.spins()) {
        return;
    }
    // A roll sensor that is out for another reason does not come back as long as the observer contradicts it.
    const bool out = (before.roll_source == RSI_ROLL_OBSERVER);
    const bool contradicted =
        out ? !rsi::is_within_magnitude(difference, 2.0F * agreement_rad) : before.roll_sensor_disagrees != 0;
    const bool disagrees = rsi::is_finite(difference) && contradicted;
    const bool lateral_is_wrong = disagrees && !out && turn_consistency_.suspicious();
    if (lateral_is_wrong) {
        memory.report(lateral, true);
    }
    memory.report(roll_sensor, disagrees && !lateral_is_wrong);
}

void InputMonitor::invalidate_confirmed(rsi::Inputs& inputs, const DiagnosticMemory& memory) const noexcept {
    const bool roll_contradiction = roll_contradicts(memory);
    if (either_confirmed(memory, DiagnosticCode::lateral_acceleration_stuck,
                         DiagnosticCode::lateral_acceleration_contradicts_yaw_rate)) {
        inputs.lateral_specific_force_mps2 = rsi::not_available;
    }
    if (either_confirmed(memory, DiagnosticCode::vertical_acceleration_stuck,
                         DiagnosticCode::vertical_acceleration_offset)) {
        inputs.vertical_specific_force_mps2 = rsi::not_available;
    }
    if (memory.confirmed(DiagnosticCode::roll_rate_stuck) || (roll_contradiction && roll_rate_is_wrong_)) {
        inputs.roll_rate_radps = rsi::not_available;
    }
    if (either_confirmed(memory, DiagnosticCode::roll_angle_stuck,
                         DiagnosticCode::roll_sensor_contradicts_observer) ||
        memory.confirmed(DiagnosticCode::roll_angle_reference_wrong) ||
        (roll_contradiction && !roll_rate_is_wrong_)) {
        inputs.roll_angle_rad = rsi::not_available;
    }
    if (either_confirmed(memory, DiagnosticCode::yaw_rate_stuck,
                         DiagnosticCode::yaw_rate_contradicts_lateral_acceleration)) {
        inputs.yaw_rate_radps = rsi::not_available;
    }
    if (memory.confirmed(DiagnosticCode::speed_stuck)) {
        inputs.speed_mps = rsi::not_available;
    }
    if (memory.confirmed(DiagnosticCode::steering_stuck)) {
        inputs.steering_wheel_angle_rad = rsi::not_available;
    }
    if (memory.confirmed(DiagnosticCode::bank_angle_invalid)) {
        inputs.bank_angle_rad = rsi::not_available;
    }
}

}  // namespace monitoring
