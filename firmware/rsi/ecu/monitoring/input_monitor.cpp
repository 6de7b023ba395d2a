#include "rsi/ecu/monitoring/input_monitor.hpp"

#include "rsi/adaptation/load_bounds.hpp"
#include "rsi/ecu/monitoring/inclination.hpp"
#include "rsi/ecu/monitoring/signatures.hpp"
#include "rsi/numeric/bounded.hpp"

namespace rsi::monitoring {
namespace {

// State of the observer: reliable again within half of what the component's own check tolerates.
constexpr float agreement_rad = 0.025F;

// No road is as steep (45 %, several times what is built), and the sensor ends at 0.785 rad.
constexpr float steepest_bank_rad = 0.42F;

// The body leans out of the turn; below this the sign of the force says nothing.
constexpr float clear_force_mps2 = 2.0F;

// A wheel that is thrown up shakes the body's roll as well, a noisy accelerometer does not.
constexpr float heave_per_roll_shake_m = 22.0F;

// The body follows a lateral force of 5 m/s^2 with 4 rad/s^2 and more: a true step ends the calm in 0.03 s.
constexpr float calm_roll_rate_radps = 0.1F;

// Nearer to the limit a tyre that slides, or grips again, makes such steps.
constexpr float everyday_force_mps2 = 3.5F;

// A speed in larger steps repeats its value in turns at a constant speed.
constexpr float largest_fine_step_mps = 0.05F;
constexpr float further_than_any_reference = 1.0e6F;

// Codes of sensors that say nothing of the accelerometer's mean. Those in which it may itself be the wrong
// one are not among them: what it is corrected by may end them.
constexpr CodeSet teaches_no_offset =
    set_of(DiagnosticCode::lateral_acceleration_stuck, DiagnosticCode::roll_angle_stuck,
           DiagnosticCode::yaw_rate_stuck, DiagnosticCode::speed_stuck, row::reference, row::yaw_rate);

// Bank of the road: measured, or as the observer has it.
float known_bank_rad(const rsi::Inputs& inputs, const rsi::Outputs& before) noexcept {
    const bool measured = rsi::is_within_magnitude(inputs.bank_angle_rad, steepest_bank_rad);
    return measured ? inputs.bank_angle_rad : before.observed_bank_angle_rad;
}

// NaN while the component makes no statement.
float sure_load_excess(const rsi::Outputs& before) noexcept {
    return (before.load_excess_deviation >= rsi::sure_load_deviation) ? 0.0F : before.load_excess;
}

// Skips rows that cannot change the code's status.
bool concerns(const Signature& row, const DiagnosticMemory& memory) noexcept {
    switch (row.action) {
        case Action::holds:
            return memory.confirmed(row.code);
        case Action::clears:
            return memory.active(row.code);
        default:
            return true;
    }
}

OfRoll wrong_of(Symptoms seen) noexcept {
    for (const RollFaultIsolation& each : roll_fault_isolation) {
        if (each.pattern.fits(seen)) {
            return each.wrong;
        }
    }
    return otherwise_wrong;
}

// Without the signals that fail by themselves: they say nothing of the others.
rsi::Inputs references_of(const rsi::Inputs& inputs, CodeSet active) noexcept {
    rsi::Inputs references = inputs;
    for (const Consequence& each : consequences) {
        if ((active & each.no_reference) != 0U) {
            references.*each.signal = rsi::not_available;
        }
    }
    return references;
}

}  // namespace

void InputMonitor::start(const rsi::Parameters& parameters) noexcept {
    // A code outlives a stall, and so must what it was set for.
    const OfRoll wrong_of_roll = wrong_of_roll_;
    const ForceGain force_gain = force_gain_;
    const TravelDirection direction = direction_;          // a stall turns no vehicle round
    const StartingAngle starting_angle = starting_angle_;  // an angle that was right before may be large now
    const MassCheck mass = mass_;
    const LateralOffset lateral_offset = lateral_offset_;
    *this = InputMonitor{};
    lateral_offset_ = lateral_offset;
    mass_ = mass;
    mass_.start(parameters);
    starting_angle_ = starting_angle;
    wrong_of_roll_ = wrong_of_roll;
    force_gain_ = force_gain;
    direction_ = direction;
    against_horizon_ = (parameters.roll_angle_reference == RSI_ROLL_AGAINST_HORIZON);
    steering_fitted_ = (parameters.vehicle_motion_sensors == RSI_MOTION_WITH_STEERING);
    if (parameters.speed_resolution_mps > largest_fine_step_mps) {
        speed_stuck_ = StuckCheck{further_than_any_reference};
    }
    lateral_.admit_noise(parameters.accelerometer_noise_mps2);
    vertical_.admit_noise(parameters.accelerometer_noise_mps2);
    roll_reference_.start(parameters);
    force_vote_.start(parameters);
}

rsi::Inputs InputMonitor::qualify(const rsi::Inputs& inputs, const FreshFrames& fresh,
                                  const rsi::Outputs& before, DiagnosticMemory& memory) noexcept {
    rsi::Inputs qualified = check_each(inputs, fresh, memory);
    const bool all_are_references = (memory.active_codes() & no_reference_codes) == 0U;
    rsi::Inputs references = all_are_references ? inputs : references_of(inputs, memory.active_codes());
    // As it came: a changing correction would hide a value that repeats itself.
    check_stuck(references, memory);
    references.lateral_specific_force_mps2 -= lateral_offset_.correction_mps2();
    const bool contradicted = (memory.confirmed_codes() & roll_contradictions) != 0U;
    Symptoms seen = roll_symptoms(references, contradicted ? fresh.late_roll_angle_rad : rsi::not_available);
    seen |= turn_symptoms(references, before, memory.confirmed_codes());
    seen |= vertical_symptoms(references, before);
    seen |= reference_symptoms(references, before);
    seen |= observer_symptoms(inputs, before);
    seen |= mass_.symptoms_with(before);
    judge(seen, memory);
    if (starting_angle_.waits(qualified.roll_angle_rad, roll_beyond_observed(inputs, before))) {
        qualified.roll_angle_rad = rsi::not_available;
    } else if (starting_angle_.is_contradicted()) {
        memory.confirm(DiagnosticCode::roll_sensor_contradicts_observer);
    } else {
        // Confirmed, or nothing to wait for.
    }
    const CodeSet confirmed = memory.confirmed_codes();
    if (confirmed != 0U) {
        if (!contradicted && ((confirmed & roll_contradictions) != 0U)) {
            wrong_of_roll_ = wrong_of(isolation_symptoms(references));
        }
        invalidate(qualified, confirmed);
    }
    return qualified;
}

// A frame that is lost has its own code; its signals are not judged.
rsi::Inputs InputMonitor::check_each(const rsi::Inputs& inputs, const FreshFrames& fresh,
                                     DiagnosticMemory& memory) noexcept {
    rsi::Inputs qualified = inputs;
    if (fresh.imu) {
        const bool calm = rsi::is_within_magnitude(inputs.roll_rate_radps, calm_roll_rate_radps) &&
                          rsi::is_within_magnitude(lateral_.last_good(), everyday_force_mps2);
        qualified.lateral_specific_force_mps2 =
            lateral_.qualify(inputs.lateral_specific_force_mps2, memory, {0.0F, 0.0F, calm}) -
            lateral_offset_.correction_mps2();
        if (fresh.vertical_acceleration) {
            flight_.update(inputs.vertical_specific_force_mps2, inputs.lateral_specific_force_mps2);
            if (flight_.excuses()) {
                qualified.vertical_specific_force_mps2 = rsi::not_available;
                vertical_.forget();
            } else {
                qualified.vertical_specific_force_mps2 =
                    vertical_.qualify(inputs.vertical_specific_force_mps2, memory,
                                      {0.0F, heave_per_roll_shake_m * roll_rate_.shake(), calm});
            }
        }
        qualified.roll_rate_radps = roll_rate_.qualify(inputs.roll_rate_radps, memory);
    } else {
        lateral_.forget();
        vertical_.forget();
        roll_rate_.forget();
    }
    if (fresh.roll_angle) {
        const float turned =
            rsi::is_finite(qualified.roll_rate_radps) ? rsi::sample_time_s * qualified.roll_rate_radps : 0.0F;
        qualified.roll_angle_rad = roll_angle_.qualify(inputs.roll_angle_rad, memory, {turned});
        // Most vehicles have no bank sensor.
        const bool has_bank = rsi::is_finite(inputs.bank_angle_rad);
        if (has_bank) {
            memory.add_tested(set_of(DiagnosticCode::bank_angle_invalid));
        }
        memory.report(DiagnosticCode::bank_angle_invalid,
                      has_bank && !rsi::is_within_magnitude(inputs.bank_angle_rad, steepest_bank_rad));
    } else {
        roll_angle_.forget();
    }
    if (fresh.vehicle_motion) {
        qualified.yaw_rate_radps = yaw_rate_.qualify(inputs.yaw_rate_radps, memory);
        qualified.speed_mps = speed_.qualify(inputs.speed_mps, memory);
        if (steering_fitted_) {
            qualified.steering_wheel_angle_rad = steering_.qualify(inputs.steering_wheel_angle_rad, memory);
        }
    } else {
        yaw_rate_.forget();
        speed_.forget();
        steering_.forget();
    }
    qualified.vehicle_mass_kg = mass_.qualify(inputs.vehicle_mass_kg, qualified.speed_mps, memory);
    return qualified;
}

void InputMonitor::check_stuck(const rsi::Inputs& inputs, DiagnosticMemory& memory) noexcept {
    const float turn = inputs.yaw_rate_radps * inputs.speed_mps;
    const float lateral = inputs.lateral_specific_force_mps2;
    // NaN when it begins anew: no reference has jumped then.
    const float sum = turned_rad_ + rsi::sample_time_s * inputs.roll_rate_radps;
    const float turned = rsi::is_within_magnitude(sum, 5.0F) ? sum : rsi::not_available;
    turned_rad_ = rsi::is_finite(turned) ? turned : 0.0F;
    // An inactive or missing reference does not clear a value that repeats itself.
    CodeSet moving = 0U;
    const auto report_as = [&memory, &moving](DiagnosticCode code, bool stuck, const auto& check) noexcept {
        moving |= check.moves() ? set_of(code) : CodeSet{0U};
        if (stuck || check.moves()) {
            memory.report(code, stuck);
        }
    };
    const auto report = [&report_as](DiagnosticCode code, auto& check, auto... signals) noexcept {
        report_as(code, check.is_stuck(signals...), check);
    };
    report(DiagnosticCode::lateral_acceleration_stuck, lateral_stuck_, lateral, turn);
    report(DiagnosticCode::vertical_acceleration_stuck, vertical_stuck_, inputs.vertical_specific_force_mps2,
           lateral);
    report(DiagnosticCode::roll_rate_stuck, roll_rate_stuck_, inputs.roll_rate_radps,
           inputs.roll_angle_rad - turned);
    report(DiagnosticCode::roll_angle_stuck, roll_angle_stuck_, inputs.roll_angle_rad, turned);
    // Either alone would hold a bank, or a wrong roll rate, against the yaw rate.
    const bool untilted =
        yaw_rate_untilted_.is_stuck(inputs.yaw_rate_radps, lateral - rsi::gravity_mps2 * turned);
    const bool level = yaw_rate_stuck_.is_stuck(inputs.yaw_rate_radps, lateral);
    report_as(DiagnosticCode::yaw_rate_stuck, level && untilted, yaw_rate_stuck_);
    speed_noise_.update(inputs.speed_mps);
    report(DiagnosticCode::speed_stuck, speed_stuck_, inputs.speed_mps,
           speed_noise_.is_known() ? turn : rsi::not_available);
    report(DiagnosticCode::steering_stuck, steering_stuck_, inputs.steering_wheel_angle_rad, lateral, turn);
    memory.add_tested(moving);
}

// An angle that is held back cannot show a contradiction, but only with it can one be over.
Symptoms InputMonitor::roll_symptoms(const rsi::Inputs& inputs, float late_roll_angle_rad) noexcept {
    const bool there = rsi::is_finite(inputs.roll_angle_rad);
    roll_consistency_.update(
        there ? inputs.roll_angle_rad : late_roll_angle_rad, inputs.roll_rate_radps,
        inclination_rad(inputs.lateral_specific_force_mps2, inputs.yaw_rate_radps * inputs.speed_mps));
    // An angle that does not fit the force points to the sensor, not the road. A ferry turns a vehicle that
    // stands.
    const bool may_twist = force_vote_.roll_motion_agrees();
    return symptom_if(roll_consistency_.known(), Symptom::roll_valid) |
           symptom_if(roll_consistency_.contradicts(may_twist), Symptom::roll_beyond_short) |
           symptom_if(roll_consistency_.has_offset(may_twist), Symptom::roll_beyond_long);
}

Symptoms InputMonitor::isolation_symptoms(const rsi::Inputs& inputs) const noexcept {
    const float force = inputs.lateral_specific_force_mps2;
    const bool clear = !rsi::is_within_magnitude(force, clear_force_mps2);
    return symptom_if(roll_angle_stuck_.seems_frozen(), Symptom::roll_angle_frozen) |
           symptom_if(roll_rate_stuck_.seems_frozen(), Symptom::roll_rate_frozen) |
           symptom_if(clear && (force * roll_against_road(inputs) < 0.0F), Symptom::leans_into_turn);
}

// The force depends so little on the roll angle that the observer's will do where the sensor's contains a
// bank.
Symptoms InputMonitor::vertical_symptoms(const rsi::Inputs& inputs, const rsi::Outputs& before) noexcept {
    vertical_offset_.update(inputs.vertical_specific_force_mps2, inputs.lateral_specific_force_mps2,
                            against_horizon_ ? before.observed_roll_angle_rad : inputs.roll_angle_rad,
                            inputs.yaw_rate_radps * inputs.speed_mps, known_bank_rad(inputs, before));
    if (flight_.excuses()) {
        return symptoms();
    }
    const bool calm = (before.state == RSI_STATE_READY) || (before.state == RSI_STATE_ADVISORY);
    return symptom_if(vertical_offset_.is_within(), Symptom::vertical_within) |
           symptom_if(vertical_offset_.is_beyond(!calm), Symptom::vertical_beyond);
}

Symptoms InputMonitor::turn_symptoms(const rsi::Inputs& inputs, const rsi::Outputs& before,
                                     CodeSet confirmed) noexcept {
    direction_.update(inputs.lateral_specific_force_mps2, inputs.yaw_rate_radps, inputs.speed_mps);
    turn_consistency_.update(inputs.lateral_specific_force_mps2, inputs.yaw_rate_radps, inputs.speed_mps,
                             direction_.is_forward());
    const float yaw_acceleration =
        turn_consistency_.known() ? inputs.yaw_rate_radps * inputs.speed_mps : rsi::not_available;
    const float roll_angle = roll_against_road(inputs);
    turn_signs_.update(inputs.lateral_specific_force_mps2, yaw_acceleration, roll_angle);
    force_vote_.assume_load(sure_load_excess(before));
    force_vote_.update(inputs, roll_angle, direction_.is_forward());
    if (LateralOffset::learns_at(yaw_acceleration)) {
        learn_offset(inputs.lateral_specific_force_mps2 - yaw_acceleration, before, confirmed);
    }
    slow_vehicle_.update(inputs);
    const bool is_impossible =
        slow_vehicle_.lateral_acceleration_is_impossible() || lateral_offset_.is_beyond();
    return gain_symptoms(before) | symptom_if(turn_consistency_.known(), Symptom::turn_valid) |
           symptom_if(turn_consistency_.agrees(), Symptom::turn_within) |
           symptom_if(rsi::absolute(yaw_acceleration) > clear_force_mps2, Symptom::turn_clear) |
           symptom_if(turn_consistency_.suspicious(), Symptom::turn_beyond_banks) |
           symptom_if(turn_consistency_.contradicts(), Symptom::turn_beyond_slides) |
           symptom_if(turn_consistency_.spins(), Symptom::spinning) |
           symptom_if(turn_signs_.lateral_acceleration_is_alone(), Symptom::lateral_sign_alone) |
           symptom_if(turn_signs_.yaw_rate_is_alone(), Symptom::yaw_sign_alone) |
           symptom_if(force_vote_.known(), Symptom::roll_force_valid) |
           symptom_if(force_vote_.roll_motion_agrees(), Symptom::roll_force_within) |
           symptom_if(force_vote_.accelerometer_is_alone(), Symptom::lateral_alone) |
           symptom_if(force_vote_.accelerometer_is_suspect(), Symptom::lateral_suspect) |
           symptom_if(is_impossible, Symptom::lateral_impossible);
}

// Without a roll motion to compare with, the yaw rate decides alone.
[[gnu::noinline]] void InputMonitor::learn_offset(float beyond_yaw_mps2, const rsi::Outputs& before,
                                                  CodeSet confirmed) noexcept {
    if (((confirmed & teaches_no_offset) == 0U) && (before.state != RSI_STATE_WARNING)) {
        lateral_offset_.update(beyond_yaw_mps2,
                               force_vote_.known() ? force_vote_.beyond_roll_mps2() : beyond_yaw_mps2);
    }
}

// Ignores an invalidated roll angle, and wheel speed during a slide, as at the end of a spin.
Symptoms InputMonitor::gain_symptoms(const rsi::Outputs& before) noexcept {
    const bool both_are_references = turn_consistency_.known() && (before.roll_source != RSI_ROLL_OBSERVER);
    if (!force_vote_.known() || !both_are_references) {
        return symptoms();
    }
    force_gain_.update(force_vote_.forces(), before.state == RSI_STATE_WARNING);
    return symptoms(Symptom::gain_valid) | symptom_if(force_gain_.is_wrong(), Symptom::gain_beyond);
}

// The angle against the road that is a reference for the other sensors. One against the horizon needs the
// bank of a sensor: the observer's is made of the very signals that are to be checked.
float InputMonitor::roll_against_road(const rsi::Inputs& inputs) const noexcept {
    return against_horizon_ ? inputs.roll_angle_rad - inputs.bank_angle_rad : inputs.roll_angle_rad;
}

// Excess of the sensor over the roll angle that the observer finds without it.
float InputMonitor::roll_beyond_observed(const rsi::Inputs& inputs,
                                         const rsi::Outputs& before) const noexcept {
    const float beyond_road = inputs.roll_angle_rad - before.observed_roll_angle_rad;
    return against_horizon_ ? beyond_road - known_bank_rad(inputs, before) : beyond_road;
}

// A wrong calibration does not show on a level road; once it has shown, no angle is what it is taken for.
Symptoms InputMonitor::reference_symptoms(const rsi::Inputs& inputs, const rsi::Outputs& before) noexcept {
    roll_reference_.update(inputs.roll_angle_rad, before.observed_roll_angle_rad,
                           known_bank_rad(inputs, before));
    const bool known = roll_reference_.known();
    return symptom_if(known, Symptom::reference_valid) |
           symptom_if(known && roll_reference_.contradicts(), Symptom::reference_beyond);
}

// The observer makes the roll angle of the lateral force and the roll rate. The component's own check,
// confirmed for 0.3 s, decides when it is reliable.
Symptoms InputMonitor::observer_symptoms(const rsi::Inputs& inputs,
                                         const rsi::Outputs& before) const noexcept {
    const float difference = roll_beyond_observed(inputs, before);
    if (!rsi::is_finite(difference)) {
        return symptoms();
    }
    const bool out = (before.roll_source == RSI_ROLL_OBSERVER);
    const bool far = !rsi::is_within_magnitude(difference, 2.0F * agreement_rad);
    return symptoms(Symptom::observer_valid) |
           symptom_if(rsi::is_within_magnitude(difference, agreement_rad), Symptom::observer_within) |
           symptom_if(!out && (before.roll_sensor_disagrees != 0), Symptom::observer_beyond) |
           symptom_if(out && far, Symptom::observer_far);
}

// Mostly there is nothing to set or clear.
void InputMonitor::judge(Symptoms seen, DiagnosticMemory& memory) noexcept {
    CodeSet good = 0U;
    for (const Proof& each : proofs) {
        good |= ((seen & each.needed) == each.needed) ? each.codes : CodeSet{0U};
    }
    memory.add_tested(good);
    if (((memory.active_codes() & judged_codes) == 0U) && ((seen & setting_symptoms) == 0U)) {
        return;
    }
    DiagnosticCode judged = DiagnosticCode::none;
    for (const Signature& each : signatures) {
        if (each.pattern.fits(seen) && (each.code != judged) && concerns(each, memory)) {
            memory.report(each.code, each.action != Action::clears);
            judged = each.code;
        }
    }
}

void InputMonitor::invalidate(rsi::Inputs& qualified, CodeSet confirmed) const noexcept {
    for (const Consequence& each : consequences) {
        if ((confirmed & each.not_used) != 0U) {
            qualified.*each.signal = rsi::not_available;
        }
    }
    if ((confirmed & roll_contradictions) != 0U) {
        const bool rate = (wrong_of_roll_ == OfRoll::rate);
        (rate ? qualified.roll_rate_radps : qualified.roll_angle_rad) = rsi::not_available;
    }
}

}  // namespace rsi::monitoring
