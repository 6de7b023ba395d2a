// Diagnostic trouble codes: the number by which a workshop knows each diagnostic code. The one table of them.
//
// Three bytes each: a manufacturer-specific base code (C1xxx and U1xxx of SAE J2012-DA: 0x5xxx and 0xDxxx),
// then the failure type byte.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/ecu/monitoring/diagnostic_code.hpp"

namespace rsi::diagnosis {

// SAE J2012-DA, failure type bytes.
namespace failure_type {
inline constexpr std::uint32_t bus_message = 0x08U;
inline constexpr std::uint32_t rate_above_limit = 0x27U;
inline constexpr std::uint32_t bias = 0x28U;
inline constexpr std::uint32_t signal_invalid = 0x29U;
inline constexpr std::uint32_t signal_stuck = 0x2AU;
inline constexpr std::uint32_t data_memory = 0x44U;
inline constexpr std::uint32_t calibration_memory = 0x46U;
inline constexpr std::uint32_t internal = 0x49U;
inline constexpr std::uint32_t configuration = 0x56U;
inline constexpr std::uint32_t calculation = 0x61U;
inline constexpr std::uint32_t comparison = 0x62U;
inline constexpr std::uint32_t plausibility = 0x64U;
inline constexpr std::uint32_t wrong_protection = 0x83U;
inline constexpr std::uint32_t missing_message = 0x87U;
inline constexpr std::uint32_t bus_off = 0x88U;
}  // namespace failure_type

struct TroubleCode {
    std::uint32_t number;  // DTC, 24 bits
    monitoring::DiagnosticCode code;
};

constexpr TroubleCode row(monitoring::DiagnosticCode code, std::uint32_t base, std::uint32_t type) {
    return TroubleCode{(base << 8U) | type, code};
}

inline constexpr std::size_t trouble_code_count = monitoring::diagnostic_code_count - 1U;  // without `none`

using monitoring::DiagnosticCode;

// In the order of the codes: the row of a code is its number less one.
inline constexpr std::array<TroubleCode, trouble_code_count> trouble_codes{
    row(DiagnosticCode::imu_lost, 0xD120U, failure_type::missing_message),
    row(DiagnosticCode::imu_damaged, 0xD120U, failure_type::wrong_protection),
    row(DiagnosticCode::roll_angle_lost, 0xD121U, failure_type::missing_message),
    row(DiagnosticCode::roll_angle_damaged, 0xD121U, failure_type::wrong_protection),
    row(DiagnosticCode::vehicle_motion_lost, 0xD122U, failure_type::missing_message),
    row(DiagnosticCode::vehicle_motion_damaged, 0xD122U, failure_type::wrong_protection),
    row(DiagnosticCode::lateral_acceleration_invalid, 0x5201U, failure_type::signal_invalid),
    row(DiagnosticCode::lateral_acceleration_jump, 0x5201U, failure_type::rate_above_limit),
    row(DiagnosticCode::lateral_acceleration_stuck, 0x5201U, failure_type::signal_stuck),
    row(DiagnosticCode::vertical_acceleration_invalid, 0x5202U, failure_type::signal_invalid),
    row(DiagnosticCode::vertical_acceleration_jump, 0x5202U, failure_type::rate_above_limit),
    row(DiagnosticCode::vertical_acceleration_stuck, 0x5202U, failure_type::signal_stuck),
    row(DiagnosticCode::vertical_acceleration_offset, 0x5202U, failure_type::bias),
    row(DiagnosticCode::roll_rate_invalid, 0x5203U, failure_type::signal_invalid),
    row(DiagnosticCode::roll_rate_jump, 0x5203U, failure_type::rate_above_limit),
    row(DiagnosticCode::roll_rate_stuck, 0x5203U, failure_type::signal_stuck),
    row(DiagnosticCode::roll_angle_invalid, 0x5204U, failure_type::signal_invalid),
    row(DiagnosticCode::roll_angle_jump, 0x5204U, failure_type::rate_above_limit),
    row(DiagnosticCode::roll_angle_stuck, 0x5204U, failure_type::signal_stuck),
    row(DiagnosticCode::bank_angle_invalid, 0x5205U, failure_type::signal_invalid),
    row(DiagnosticCode::yaw_rate_invalid, 0x5206U, failure_type::signal_invalid),
    row(DiagnosticCode::yaw_rate_jump, 0x5206U, failure_type::rate_above_limit),
    row(DiagnosticCode::yaw_rate_stuck, 0x5206U, failure_type::signal_stuck),
    row(DiagnosticCode::speed_invalid, 0x5207U, failure_type::signal_invalid),
    row(DiagnosticCode::speed_jump, 0x5207U, failure_type::rate_above_limit),
    row(DiagnosticCode::speed_stuck, 0x5207U, failure_type::signal_stuck),
    row(DiagnosticCode::steering_invalid, 0x5208U, failure_type::signal_invalid),
    row(DiagnosticCode::steering_jump, 0x5208U, failure_type::rate_above_limit),
    row(DiagnosticCode::steering_stuck, 0x5208U, failure_type::signal_stuck),
    row(DiagnosticCode::roll_rate_contradicts_roll_angle, 0x5203U, failure_type::plausibility),
    row(DiagnosticCode::roll_rate_offset, 0x5203U, failure_type::bias),
    row(DiagnosticCode::lateral_acceleration_contradicts_yaw_rate, 0x5201U, failure_type::plausibility),
    row(DiagnosticCode::roll_sensor_contradicts_observer, 0x5204U, failure_type::plausibility),
    row(DiagnosticCode::yaw_rate_contradicts_lateral_acceleration, 0x5206U, failure_type::plausibility),
    row(DiagnosticCode::parameters_refused, 0x5210U, failure_type::configuration),
    row(DiagnosticCode::parameters_damaged, 0x5210U, failure_type::calibration_memory),
    row(DiagnosticCode::estimate_out_of_range, 0x5211U, failure_type::calculation),
    row(DiagnosticCode::output_not_finite, 0x5212U, failure_type::calculation),
    row(DiagnosticCode::cycle_overrun, 0x5213U, failure_type::internal),
    row(DiagnosticCode::cycle_stall, 0x5214U, failure_type::internal),
    row(DiagnosticCode::clock_jump, 0x5215U, failure_type::internal),
    row(DiagnosticCode::bus_error, 0xD001U, failure_type::bus_off),
    row(DiagnosticCode::receive_overflow, 0xD001U, failure_type::bus_message),
    row(DiagnosticCode::roll_angle_reference_wrong, 0x5204U, failure_type::configuration),
    row(DiagnosticCode::lateral_acceleration_gain, 0x5201U, failure_type::comparison),
    row(DiagnosticCode::memory_restored, 0x5216U, failure_type::data_memory),
    row(DiagnosticCode::imu_two_senders, 0xD120U, failure_type::bus_message),
    row(DiagnosticCode::roll_angle_two_senders, 0xD121U, failure_type::bus_message),
    row(DiagnosticCode::vehicle_motion_two_senders, 0xD122U, failure_type::bus_message),
    row(DiagnosticCode::own_identifier_received, 0xD0D0U, failure_type::bus_message),
    row(DiagnosticCode::imu_held_back, 0xD120U, failure_type::plausibility),
    row(DiagnosticCode::stored_parameters_refused, 0x5217U, failure_type::calibration_memory),
    row(DiagnosticCode::storage_failed, 0x5217U, failure_type::data_memory),
    row(DiagnosticCode::vehicle_mass_invalid, 0x5209U, failure_type::signal_invalid),
    row(DiagnosticCode::vehicle_mass_jump, 0x5209U, failure_type::rate_above_limit),
    row(DiagnosticCode::vehicle_mass_contradicts_load, 0x5209U, failure_type::plausibility),
};

constexpr bool is_table_of_all(const std::array<TroubleCode, trouble_code_count>& table) {
    bool good = true;
    for (std::size_t index = 0U; index < trouble_code_count; ++index) {
        good = good && (static_cast<std::size_t>(table[index].code) == index + 1U);
        for (std::size_t other = 0U; other < index; ++other) {
            good = good && (table[index].number != table[other].number);
        }
    }
    return good;
}
static_assert(is_table_of_all(trouble_codes),
              "every code has its row, in the order of the codes, and a number of its own");

// Only the numbers get into an image; the rest of the table is used at compile time.
constexpr std::array<std::uint32_t, trouble_code_count> numbers_of_all() {
    std::array<std::uint32_t, trouble_code_count> numbers{};
    for (std::size_t index = 0U; index < trouble_code_count; ++index) {
        numbers[index] = trouble_codes[index].number;
    }
    return numbers;
}
inline constexpr std::array<std::uint32_t, trouble_code_count> trouble_code_numbers = numbers_of_all();

// Row of the DTC with that number; trouble_code_count for an unknown one.
constexpr std::size_t row_of_number(std::uint32_t number) {
    std::size_t index = 0U;
    while ((index < trouble_code_count) && (trouble_code_numbers[index] != number)) {
        ++index;
    }
    return index;
}

}  // namespace rsi::diagnosis
