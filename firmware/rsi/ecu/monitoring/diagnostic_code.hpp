// Diagnostic codes: faults that the monitoring detects, and their debouncing.
#pragma once

#include "rsi/language.hpp"

#include <cstddef>
#include <cstdint>

namespace rsi::monitoring {

// docs/safety.md has the table of them: condition, threshold, reaction.
enum class DiagnosticCode : std::uint8_t {
    none,

    // Frames
    imu_lost,
    imu_damaged,
    roll_angle_lost,
    roll_angle_damaged,
    vehicle_motion_lost,
    vehicle_motion_damaged,

    // Single signals: invalid (not available, or outside its physical range), jump (gradient or noise beyond
    // any vehicle motion), stuck (constant although other signals show motion)
    lateral_acceleration_invalid,
    lateral_acceleration_jump,
    lateral_acceleration_stuck,
    vertical_acceleration_invalid,
    vertical_acceleration_jump,
    vertical_acceleration_stuck,
    vertical_acceleration_offset,
    roll_rate_invalid,
    roll_rate_jump,
    roll_rate_stuck,
    roll_angle_invalid,
    roll_angle_jump,
    roll_angle_stuck,
    bank_angle_invalid,
    yaw_rate_invalid,
    yaw_rate_jump,
    yaw_rate_stuck,
    speed_invalid,
    speed_jump,
    speed_stuck,
    steering_invalid,
    steering_jump,
    steering_stuck,

    // Signals against each other
    roll_rate_contradicts_roll_angle,
    roll_rate_offset,
    lateral_acceleration_contradicts_yaw_rate,
    roll_sensor_contradicts_observer,
    yaw_rate_contradicts_lateral_acceleration,

    // The control unit itself
    parameters_refused,
    parameters_damaged,
    estimate_out_of_range,
    output_not_finite,
    cycle_overrun,
    cycle_stall,
    clock_jump,
    bus_error,
    receive_overflow,

    // From here on in the order of their introduction, because service tools rely on the numbers above.
    // Calibration against the sensors
    roll_angle_reference_wrong,

    // A sensor against the others, over turns
    lateral_acceleration_gain,

    // The control unit's own memory
    memory_restored,

    // A frame rate beyond that of one sender
    imu_two_senders,
    roll_angle_two_senders,
    vehicle_motion_two_senders,

    // A frame of this control unit, sent by another node
    own_identifier_received,

    // Frames in order, but with a constant delay
    imu_held_back,

    // Non-volatile memory
    stored_parameters_refused,
    storage_failed,

    // The vehicle's mass: single, and against the load that driving has shown
    vehicle_mass_invalid,
    vehicle_mass_jump,
    vehicle_mass_contradicts_load,
};

inline constexpr std::size_t diagnostic_code_count =
    static_cast<std::size_t>(DiagnosticCode::vehicle_mass_contradicts_load) + 1U;

// Set of codes: bit n stands for the code with number n.
using CodeSet = std::uint64_t;
static_assert(diagnostic_code_count <= 64U);

template <typename... Codes>
constexpr CodeSet set_of(Codes... codes) noexcept {
    return (CodeSet{0U} | ... | (CodeSet{1U} << static_cast<unsigned>(codes)));
}

// Cycles of 10 ms: consecutive failed ones until a code is confirmed (DiagnosticEvent has the rule for
// interrupted faults), and consecutive passed ones until it heals.
struct Debounce {
    std::uint16_t confirm{1U};
    std::uint16_t heal{1U};
};

Debounce debounce_of(DiagnosticCode code) noexcept;

}  // namespace rsi::monitoring
