// Fault signatures: the pattern of symptoms that sets each code, and the signal that it invalidates. The
// three tables decide, and what reads them does not: docs/reports/safety/signatures.md is printed from them.
#pragma once

#include <array>
#include <cstdint>

#include "rsi/ecu/monitoring/diagnostic_code.hpp"
#include "rsi/ecu/monitoring/symptom.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

using SensorSignal = float rsi::Inputs::*;

enum class Action : std::uint8_t {
    sets,
    holds,   // a code that is confirmed stays so
    clears,  // a code that is active is shown to be over
};

// Fits when all of `needed` is seen and none of `excuses`.
struct Pattern {
    Symptoms needed;
    Symptoms excuses;

    constexpr bool fits(Symptoms seen) const noexcept { return (seen & (needed | excuses)) == needed; }
};

struct Signature {
    DiagnosticCode code;
    Action action;
    Pattern pattern;

    constexpr Signature with(Symptom other) const noexcept {
        return {code, action, {pattern.needed | symptoms(other), pattern.excuses}};
    }
    constexpr Signature unless(Symptom excuse) const noexcept {
        return {code, action, {pattern.needed, pattern.excuses | symptoms(excuse)}};
    }
};

constexpr Signature sets(DiagnosticCode code, Symptom symptom) noexcept {
    return {code, Action::sets, {symptoms(symptom), symptoms()}};
}
constexpr Signature holds(DiagnosticCode code, Symptom symptom) noexcept {
    return {code, Action::holds, {symptoms(symptom), symptoms()}};
}
constexpr Signature clears(DiagnosticCode code, Symptom symptom) noexcept {
    return {code, Action::clears, {symptoms(symptom), symptoms()}};
}

namespace row {

inline constexpr DiagnosticCode lateral = DiagnosticCode::lateral_acceleration_contradicts_yaw_rate;
inline constexpr DiagnosticCode gain = DiagnosticCode::lateral_acceleration_gain;
inline constexpr DiagnosticCode yaw_rate = DiagnosticCode::yaw_rate_contradicts_lateral_acceleration;
inline constexpr DiagnosticCode roll_sensor = DiagnosticCode::roll_sensor_contradicts_observer;
inline constexpr DiagnosticCode roll_short = DiagnosticCode::roll_rate_contradicts_roll_angle;
inline constexpr DiagnosticCode roll_long = DiagnosticCode::roll_rate_offset;
inline constexpr DiagnosticCode vertical = DiagnosticCode::vertical_acceleration_offset;
inline constexpr DiagnosticCode reference = DiagnosticCode::roll_angle_reference_wrong;
inline constexpr DiagnosticCode mass = DiagnosticCode::vehicle_mass_contradicts_load;

}  // namespace row

// The first row of each code that fits counts. If none does, the code is neither set nor cleared.
inline constexpr std::array<Signature, 28> signatures{{
    sets(row::lateral, Symptom::lateral_sign_alone),
    sets(row::lateral, Symptom::lateral_impossible),
    sets(row::lateral, Symptom::lateral_alone).unless(Symptom::spinning).unless(Symptom::roll_force_within),
    // The observer is made of it, and something else contradicts it too.
    sets(row::lateral, Symptom::observer_beyond)
        .with(Symptom::turn_beyond_banks)
        .unless(Symptom::spinning)
        .unless(Symptom::roll_force_within),
    sets(row::lateral, Symptom::observer_beyond)
        .with(Symptom::lateral_suspect)
        .unless(Symptom::spinning)
        .unless(Symptom::roll_force_within),
    clears(row::lateral, Symptom::turn_within),
    // A yaw rate that alone is ahead, as in a weave near the limit, shows nothing.
    holds(row::lateral, Symptom::turn_valid).unless(Symptom::roll_force_within),
    holds(row::lateral, Symptom::roll_force_valid).unless(Symptom::roll_force_within),

    sets(row::gain, Symptom::gain_beyond),
    clears(row::gain, Symptom::gain_valid),

    clears(row::yaw_rate, Symptom::turn_within),
    holds(row::yaw_rate, Symptom::turn_valid),
    sets(row::yaw_rate, Symptom::turn_beyond_slides),
    sets(row::yaw_rate, Symptom::yaw_sign_alone),

    clears(row::roll_sensor, Symptom::observer_within),
    holds(row::roll_sensor, Symptom::observer_valid),
    // In a spin the observer, whose tyres roll, is no reference.
    sets(row::roll_sensor, Symptom::observer_far).unless(Symptom::spinning),
    sets(row::roll_sensor, Symptom::observer_beyond)
        .unless(Symptom::spinning)
        .unless(Symptom::turn_beyond_banks)
        .unless(Symptom::lateral_suspect)
        .unless(Symptom::roll_force_within),

    sets(row::roll_short, Symptom::roll_beyond_short),
    clears(row::roll_short, Symptom::roll_valid),
    sets(row::roll_long, Symptom::roll_beyond_long),
    clears(row::roll_long, Symptom::roll_valid),

    sets(row::vertical, Symptom::vertical_beyond),
    clears(row::vertical, Symptom::vertical_within),

    sets(row::reference, Symptom::reference_beyond),
    clears(row::reference, Symptom::reference_valid),

    sets(row::mass, Symptom::load_beyond),
    clears(row::mass, Symptom::load_valid),
}};

// Each of these symptoms sets the code by itself; without one of them no code is set anew.
constexpr Symptoms find_setting_symptoms() noexcept {
    Symptoms all = 0U;
    for (const Signature& each : signatures) {
        const Symptoms needed = each.pattern.needed;
        const bool is_alone = (needed & (needed - 1U)) == 0U;
        all |= (is_alone && (each.action == Action::sets)) ? needed : Symptoms{0U};
    }
    return all;
}
inline constexpr Symptoms setting_symptoms = find_setting_symptoms();

// Codes of which symptoms are a good test: their checks are enabled, and find nothing unless a row sets the
// code. A symptom that clears a code also shows, if need be with another, that there is none.
struct Proof {
    Symptoms needed;
    CodeSet codes;

    constexpr Proof with(Symptom other) const noexcept { return {needed | symptoms(other), codes}; }
};

constexpr Proof proof_by(Symptom symptom) noexcept {
    Proof proof{symptoms(symptom), 0U};
    for (const Signature& each : signatures) {
        const bool is_shown = (each.action == Action::clears) && (each.pattern.needed == proof.needed);
        proof.codes |= is_shown ? set_of(each.code) : CodeSet{0U};
    }
    return proof;
}

inline constexpr std::array<Proof, 7> proofs{
    // Straight on nothing is seen of the yaw rate, and little of the force.
    proof_by(Symptom::turn_within).with(Symptom::turn_clear),
    proof_by(Symptom::gain_valid),
    proof_by(Symptom::observer_within),
    proof_by(Symptom::roll_valid),
    proof_by(Symptom::vertical_within),
    proof_by(Symptom::reference_valid),
    proof_by(Symptom::load_valid),
};

constexpr CodeSet find_judged_codes() noexcept {
    CodeSet all = 0U;
    for (const Signature& each : signatures) {
        all |= set_of(each.code);
    }
    return all;
}
inline constexpr CodeSet judged_codes = find_judged_codes();

constexpr CodeSet find_proven_codes() noexcept {
    CodeSet all = 0U;
    for (const Proof& each : proofs) {
        all |= each.codes;
    }
    return all;
}
static_assert(find_proven_codes() == judged_codes, "each code can be shown to be over");

// Isolation of roll rate and roll angle that contradict each other: the first row that fits names the faulty
// one; if none does, it is the roll rate, without which there is no statement on the risk.
enum class OfRoll : std::uint8_t { rate, angle };
struct RollFaultIsolation {
    Pattern pattern;
    OfRoll wrong;
};
inline constexpr std::array<RollFaultIsolation, 3> roll_fault_isolation{{
    RollFaultIsolation{{symptoms(Symptom::roll_angle_frozen), symptoms(Symptom::roll_rate_frozen)},
                       OfRoll::angle},
    RollFaultIsolation{{symptoms(Symptom::roll_rate_frozen), symptoms(Symptom::roll_angle_frozen)},
                       OfRoll::rate},
    RollFaultIsolation{{symptoms(Symptom::leans_into_turn), symptoms()}, OfRoll::angle},
}};
inline constexpr OfRoll otherwise_wrong = OfRoll::rate;
inline constexpr CodeSet roll_contradictions = set_of(row::roll_short, row::roll_long);

// Effect of each code on its signal, beside these two. While one that the signal sets by itself is active it
// is no reference for another. While one of the others is confirmed it is not used; with its own, its check
// gives no value.
inline constexpr CodeSet mass_codes =
    set_of(DiagnosticCode::vehicle_mass_invalid, DiagnosticCode::vehicle_mass_jump, row::mass);
struct Consequence {
    SensorSignal signal;
    CodeSet no_reference;
    CodeSet not_used;
};
inline constexpr std::array<Consequence, 9> consequences{{
    Consequence{
        &rsi::Inputs::lateral_specific_force_mps2,
        set_of(DiagnosticCode::lateral_acceleration_invalid, DiagnosticCode::lateral_acceleration_jump),
        set_of(DiagnosticCode::lateral_acceleration_stuck, row::lateral, row::gain)},
    Consequence{
        &rsi::Inputs::vertical_specific_force_mps2,
        set_of(DiagnosticCode::vertical_acceleration_invalid, DiagnosticCode::vertical_acceleration_jump),
        set_of(DiagnosticCode::vertical_acceleration_stuck, row::vertical)},
    Consequence{&rsi::Inputs::roll_rate_radps,
                set_of(DiagnosticCode::roll_rate_invalid, DiagnosticCode::roll_rate_jump),
                set_of(DiagnosticCode::roll_rate_stuck)},
    Consequence{&rsi::Inputs::roll_angle_rad,
                set_of(DiagnosticCode::roll_angle_invalid, DiagnosticCode::roll_angle_jump),
                set_of(DiagnosticCode::roll_angle_stuck, row::roll_sensor, row::reference)},
    Consequence{&rsi::Inputs::yaw_rate_radps,
                set_of(DiagnosticCode::yaw_rate_invalid, DiagnosticCode::yaw_rate_jump),
                set_of(DiagnosticCode::yaw_rate_stuck, row::yaw_rate)},
    Consequence{&rsi::Inputs::speed_mps, set_of(DiagnosticCode::speed_invalid, DiagnosticCode::speed_jump),
                set_of(DiagnosticCode::speed_stuck)},
    Consequence{&rsi::Inputs::steering_wheel_angle_rad,
                set_of(DiagnosticCode::steering_invalid, DiagnosticCode::steering_jump),
                set_of(DiagnosticCode::steering_stuck)},
    Consequence{&rsi::Inputs::bank_angle_rad, set_of(), set_of(DiagnosticCode::bank_angle_invalid)},
    Consequence{&rsi::Inputs::vehicle_mass_kg, set_of(), mass_codes},
}};

constexpr CodeSet find_no_reference_codes() noexcept {
    CodeSet all = 0U;
    for (const Consequence& each : consequences) {
        all |= each.no_reference;
    }
    return all;
}
inline constexpr CodeSet no_reference_codes = find_no_reference_codes();

}  // namespace rsi::monitoring
