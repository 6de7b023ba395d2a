#include "rsi/ecu/monitoring/diagnostic_code.hpp"

namespace rsi::monitoring {

Debounce debounce_of(DiagnosticCode code) noexcept {
    switch (code) {
        case DiagnosticCode::imu_lost:
        case DiagnosticCode::roll_angle_lost:
        case DiagnosticCode::vehicle_motion_lost:
            return {1U, 10U};  // the time limit of the frame is the debounce
        case DiagnosticCode::imu_damaged:
        case DiagnosticCode::roll_angle_damaged:
        case DiagnosticCode::vehicle_motion_damaged:
            return {3U, 100U};
        case DiagnosticCode::imu_two_senders:
        case DiagnosticCode::roll_angle_two_senders:
        case DiagnosticCode::vehicle_motion_two_senders:
            return {1U, 100U};  // the surplus of frames is the debounce
        case DiagnosticCode::lateral_acceleration_invalid:
        case DiagnosticCode::vertical_acceleration_invalid:
        case DiagnosticCode::roll_rate_invalid:
        case DiagnosticCode::roll_angle_invalid:
        case DiagnosticCode::yaw_rate_invalid:
        case DiagnosticCode::speed_invalid:
        case DiagnosticCode::steering_invalid:
        case DiagnosticCode::bank_angle_invalid:
        case DiagnosticCode::vehicle_mass_invalid:
            return {3U, 5U};
        case DiagnosticCode::lateral_acceleration_jump:
        case DiagnosticCode::vertical_acceleration_jump:
        case DiagnosticCode::roll_rate_jump:
        case DiagnosticCode::roll_angle_jump:
        case DiagnosticCode::yaw_rate_jump:
        case DiagnosticCode::speed_jump:
        case DiagnosticCode::steering_jump:
        case DiagnosticCode::vehicle_mass_jump:
            return {3U, 50U};
        case DiagnosticCode::lateral_acceleration_stuck:
        case DiagnosticCode::vertical_acceleration_stuck:
        case DiagnosticCode::roll_rate_stuck:
        case DiagnosticCode::roll_angle_stuck:
        case DiagnosticCode::yaw_rate_stuck:
        case DiagnosticCode::speed_stuck:
        case DiagnosticCode::steering_stuck:
            return {1U, 20U};  // the run of equal values is the debounce
        case DiagnosticCode::lateral_acceleration_contradicts_yaw_rate:
        case DiagnosticCode::roll_sensor_contradicts_observer:
        case DiagnosticCode::yaw_rate_contradicts_lateral_acceleration:
            return {1U, 100U};  // their filters, and the component's own check, are the debounce
        case DiagnosticCode::lateral_acceleration_gain:
            return {1U, 20U};  // its sums are the debounce
        case DiagnosticCode::roll_angle_reference_wrong:
            return {1U, 500U};  // its count is the debounce
        case DiagnosticCode::parameters_refused:
        case DiagnosticCode::stored_parameters_refused:
        case DiagnosticCode::storage_failed:
            return {1U, 1U};
        case DiagnosticCode::parameters_damaged:
        case DiagnosticCode::memory_restored:
        case DiagnosticCode::estimate_out_of_range:
        case DiagnosticCode::output_not_finite:
        case DiagnosticCode::cycle_overrun:
        case DiagnosticCode::cycle_stall:
        case DiagnosticCode::clock_jump:
        case DiagnosticCode::receive_overflow:
        case DiagnosticCode::own_identifier_received:
        case DiagnosticCode::imu_held_back:
            return {1U, 100U};
        default:  // roll rate against roll angle, offsets, the bus
            return {3U, 100U};
    }
}

}  // namespace rsi::monitoring
