// Symptoms: what the relations between the sensors show in one cycle, one bit each.
#pragma once

#include <cstdint>

namespace rsi::monitoring {

// State of a residual: valid, it can be judged; within, it is small; beyond, it is not. Its own header has
// the bounds, and what makes them wider.
enum class Symptom : std::uint8_t {
    // Lateral acceleration, yaw rate times speed: turn_consistency.hpp, turn_signs.hpp
    turn_valid,
    turn_within,
    turn_beyond_banks,
    turn_beyond_slides,
    turn_clear,
    spinning,
    lateral_sign_alone,
    yaw_sign_alone,

    // The same, and the force that rolls the body: force_vote.hpp, force_gain.hpp
    roll_force_valid,
    roll_force_within,
    lateral_alone,
    lateral_suspect,
    gain_valid,
    gain_beyond,

    // Lateral acceleration, what a slow vehicle can have, or a sensor over minutes: slow_vehicle.hpp,
    // lateral_offset.hpp
    lateral_impossible,

    // Roll angle, integrated roll rate: roll_consistency.hpp
    roll_valid,
    roll_beyond_short,
    roll_beyond_long,
    roll_angle_frozen,
    roll_rate_frozen,
    leans_into_turn,

    // Roll angle, that of the observer. Beyond: of a sensor in use; far: of one that is out for another
    // reason
    observer_valid,
    observer_within,
    observer_beyond,
    observer_far,

    // Vertical acceleration, gravity: vertical_offset.hpp
    vertical_within,
    vertical_beyond,

    // Roll angle, road and horizon: roll_reference_check.hpp
    reference_valid,
    reference_beyond,

    // Vehicle mass, learnt load: mass_check.hpp
    load_valid,
    load_beyond,

    count,
};

using Symptoms = std::uint32_t;
static_assert(static_cast<unsigned>(Symptom::count) <= 32U);

template <typename... Each>
constexpr Symptoms symptoms(Each... each) noexcept {
    return (Symptoms{0U} | ... | (Symptoms{1U} << static_cast<unsigned>(each)));
}

constexpr Symptoms symptom_if(bool is_so, Symptom symptom) noexcept {
    return is_so ? symptoms(symptom) : Symptoms{0U};
}

}  // namespace rsi::monitoring
