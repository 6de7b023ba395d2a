// Fault signatures: the pattern of symptoms that sets each code, and the signal that it invalidates. The
// three tables decide, and what reads them does not: docs/reports/safety/signatures.md is printed from them.
#pragma once

#include <array>
#include <cstdint>

#include "rsi/ecu/monitoring/diagnostic_code.hpp"
#include "rsi/ecu/monitoring/fact.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

using SensorSignal = float rsi::Inputs::*;

enum class Verdict : std::uint8_t {
    accuses,
    keeps,    // a code that is confirmed stays so
    acquits,  // a code that is active is shown to be over
};

// Fits when all of `needed` is seen and none of `excuses`.
struct Pattern {
    Facts needed;
    Facts excuses;

    constexpr bool fits(Facts seen) const noexcept { return (seen & (needed | excuses)) == needed; }
};

struct Signature {
    DiagnosticCode code;
    Verdict verdict;
    Pattern pattern;

    constexpr Signature with(Fact other) const noexcept {
        return {code, verdict, {pattern.needed | facts(other), pattern.excuses}};
    }
    constexpr Signature unless(Fact excuse) const noexcept {
        return {code, verdict, {pattern.needed, pattern.excuses | facts(excuse)}};
    }
};

constexpr Signature accuses(DiagnosticCode code, Fact fact) noexcept {
    return {code, Verdict::accuses, {facts(fact), facts()}};
}
constexpr Signature keeps(DiagnosticCode code, Fact fact) noexcept {
    return {code, Verdict::keeps, {facts(fact), facts()}};
}
constexpr Signature acquits(DiagnosticCode code, Fact fact) noexcept {
    return {code, Verdict::acquits, {facts(fact), facts()}};
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

}  // namespace row

// The first row of each code that fits counts. If none does, the code is neither set nor cleared.
inline constexpr std::array<Signature, 26> signatures{{
    accuses(row::lateral, Fact::lateral_sign_alone),
    accuses(row::lateral, Fact::slow_vehicle_beyond),
    accuses(row::lateral, Fact::lateral_alone).unless(Fact::spinning),
    // The observer is made of it, and something else contradicts it too.
    accuses(row::lateral, Fact::observer_beyond).with(Fact::turn_beyond_banks).unless(Fact::spinning),
    accuses(row::lateral, Fact::observer_beyond).with(Fact::lateral_suspect).unless(Fact::spinning),
    acquits(row::lateral, Fact::turn_within),
    // A yaw rate that alone is ahead, as in a weave near the limit, shows nothing.
    keeps(row::lateral, Fact::turn_valid).unless(Fact::roll_force_within),
    keeps(row::lateral, Fact::roll_force_valid).unless(Fact::roll_force_within),

    accuses(row::gain, Fact::gain_beyond),
    acquits(row::gain, Fact::gain_valid),

    acquits(row::yaw_rate, Fact::turn_within),
    keeps(row::yaw_rate, Fact::turn_valid),
    accuses(row::yaw_rate, Fact::turn_beyond_slides),
    accuses(row::yaw_rate, Fact::yaw_sign_alone),

    acquits(row::roll_sensor, Fact::observer_within),
    keeps(row::roll_sensor, Fact::observer_valid),
    // In a spin the observer, whose tyres roll, is no reference.
    accuses(row::roll_sensor, Fact::observer_far).unless(Fact::spinning),
    accuses(row::roll_sensor, Fact::observer_beyond)
        .unless(Fact::spinning)
        .unless(Fact::turn_beyond_banks)
        .unless(Fact::lateral_suspect),

    accuses(row::roll_short, Fact::roll_beyond_short),
    acquits(row::roll_short, Fact::roll_valid),
    accuses(row::roll_long, Fact::roll_beyond_long),
    acquits(row::roll_long, Fact::roll_valid),

    accuses(row::vertical, Fact::vertical_beyond),
    acquits(row::vertical, Fact::vertical_within),

    accuses(row::reference, Fact::reference_beyond),
    acquits(row::reference, Fact::reference_valid),
}};

// Each of these symptoms sets the code by itself; without one of them no code is set anew.
constexpr Facts find_accusing_facts() noexcept {
    Facts all = 0U;
    for (const Signature& each : signatures) {
        const Facts needed = each.pattern.needed;
        const bool is_alone = (needed & (needed - 1U)) == 0U;
        all |= (is_alone && (each.verdict == Verdict::accuses)) ? needed : Facts{0U};
    }
    return all;
}
inline constexpr Facts accusing_facts = find_accusing_facts();

constexpr CodeSet find_judged_codes() noexcept {
    CodeSet all = 0U;
    for (const Signature& each : signatures) {
        all |= set_of(each.code);
    }
    return all;
}
inline constexpr CodeSet judged_codes = find_judged_codes();

// Isolation of roll rate and roll angle that contradict each other: the first row that fits names the faulty
// one; if none does, it is the roll rate, without which there is no statement on the risk.
enum class OfRoll : std::uint8_t { rate, angle };
struct Suspicion {
    Pattern pattern;
    OfRoll wrong;
};
inline constexpr std::array<Suspicion, 3> suspicions{{
    Suspicion{{facts(Fact::roll_angle_frozen), facts(Fact::roll_rate_frozen)}, OfRoll::angle},
    Suspicion{{facts(Fact::roll_rate_frozen), facts(Fact::roll_angle_frozen)}, OfRoll::rate},
    Suspicion{{facts(Fact::leans_into_turn), facts()}, OfRoll::angle},
}};
inline constexpr OfRoll otherwise_wrong = OfRoll::rate;
inline constexpr CodeSet roll_contradictions = set_of(row::roll_short, row::roll_long);

// Effect of each code on its signal, beside these two. While one that the signal sets by itself is active it
// is no reference for another. While one of the others is confirmed it is not used; with its own, its check
// gives no value.
struct Consequence {
    SensorSignal signal;
    CodeSet no_witness;
    CodeSet not_used;
};
inline constexpr std::array<Consequence, 8> consequences{{
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
}};

constexpr CodeSet find_no_witness_codes() noexcept {
    CodeSet all = 0U;
    for (const Consequence& each : consequences) {
        all |= each.no_witness;
    }
    return all;
}
inline constexpr CodeSet no_witness_codes = find_no_witness_codes();

}  // namespace rsi::monitoring
