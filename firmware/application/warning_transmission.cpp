#include "application/warning_transmission.hpp"

#include "rsi/version.h"

namespace application {
namespace {

// One digit of four bits each; the patch number is left out, since a receiver notices nothing of a patch.
static_assert(RSI_VERSION_MAJOR <= 15 && RSI_VERSION_MINOR <= 15);
constexpr std::uint8_t software_version = (RSI_VERSION_MAJOR * 16U) + RSI_VERSION_MINOR;

std::uint8_t saturate(std::uint32_t count) {
    return (count < 255U) ? static_cast<std::uint8_t>(count) : std::uint8_t{255U};
}

constexpr float degrees_per_radian = 57.295780F;
constexpr float kmh_per_mps = 3.6F;

can_dbc::RolloverWarning warning_message(const rsi::Outputs& outputs, ParametersRefusal refusal) {
    can_dbc::RolloverWarning message{};
    message.state = static_cast<can_dbc::RolloverWarning::State>(outputs.state);
    message.side = static_cast<can_dbc::RolloverWarning::Side>(outputs.side);
    message.parameters_refusal = static_cast<can_dbc::RolloverWarning::ParametersRefusal>(refusal);
    message.roll_stability_indicator = outputs.warning_level;
    message.lateral_acceleration_mps2 = outputs.lateral_acceleration_mps2;
    message.lateral_acceleration_threshold_mps2 = outputs.lateral_acceleration_threshold_mps2;
    return message;
}

static_assert(static_cast<int>(can_dbc::RolloverWarning::State::unavailable) == RSI_STATE_UNAVAILABLE);
static_assert(static_cast<int>(can_dbc::RolloverWarning::State::ready) == RSI_STATE_READY);
static_assert(static_cast<int>(can_dbc::RolloverWarning::State::advisory) == RSI_STATE_ADVISORY);
static_assert(static_cast<int>(can_dbc::RolloverWarning::State::warning) == RSI_STATE_WARNING);
static_assert(static_cast<int>(can_dbc::RolloverWarning::Side::none) == RSI_SIDE_NONE);
static_assert(static_cast<int>(can_dbc::RolloverWarning::Side::left) == RSI_SIDE_LEFT);
static_assert(static_cast<int>(can_dbc::RolloverWarning::Side::right) == RSI_SIDE_RIGHT);

// The numbers of an enumeration are those of the DBC.
template <auto value, auto sent>
inline constexpr bool is_sent_as = (static_cast<int>(value) == static_cast<int>(sent));
static_assert(is_sent_as<ParametersRefusal::none, can_dbc::RolloverWarning::ParametersRefusal::none>);
static_assert(is_sent_as<ParametersRefusal::missing, can_dbc::RolloverWarning::ParametersRefusal::missing>);
static_assert(is_sent_as<ParametersRefusal::version, can_dbc::RolloverWarning::ParametersRefusal::version>);
static_assert(is_sent_as<ParametersRefusal::layout, can_dbc::RolloverWarning::ParametersRefusal::layout>);
static_assert(is_sent_as<ParametersRefusal::length, can_dbc::RolloverWarning::ParametersRefusal::length>);
static_assert(is_sent_as<ParametersRefusal::checksum, can_dbc::RolloverWarning::ParametersRefusal::checksum>);
static_assert(is_sent_as<ParametersRefusal::value, can_dbc::RolloverWarning::ParametersRefusal::value>);

can_dbc::RollCentreEstimate estimate_message(const rsi::Outputs& outputs) {
    can_dbc::RollCentreEstimate message{};
    message.vertical_movement_m = outputs.roll_centre_vertical_m;
    message.lateral_movement_m = outputs.roll_centre_lateral_m;
    message.roll_stiffness_deviation_n_m_per_rad = outputs.roll_stiffness_deviation_nmprad;
    message.roll_damping_deviation_n_m_s_per_rad = outputs.roll_damping_deviation_nmsprad;
    return message;
}

can_dbc::RollIndicesAhead indices_ahead_message(const rsi::Outputs& outputs) {
    can_dbc::RollIndicesAhead message{};
    message.predicted_load_transfer_ratio = outputs.predicted_load_transfer_ratio;
    message.predicted_rsi = outputs.predicted_rsi;
    message.load_transfer_ratio = outputs.load_transfer_ratio;
    message.extended_rsi = outputs.rsi_extended;
    return message;
}

can_dbc::RollIndicesClassic indices_classic_message(const rsi::Outputs& outputs) {
    can_dbc::RollIndicesClassic message{};
    message.published_rsi = outputs.rsi;
    message.bank_free_rsi = outputs.rsi_bank_free;
    message.dynamic_stability_index = outputs.dynamic_stability_index;
    message.energy_margin = outputs.energy_margin;
    message.rollover_index = outputs.rollover_index;
    message.time_to_rollover_s = outputs.time_to_rollover_s;
    return message;
}

static_assert(static_cast<int>(can_dbc::RollObserver::RollSource::none) == RSI_ROLL_NONE);
static_assert(static_cast<int>(can_dbc::RollObserver::RollSource::sensor) == RSI_ROLL_SENSOR);
static_assert(static_cast<int>(can_dbc::RollObserver::RollSource::observer) == RSI_ROLL_OBSERVER);

can_dbc::RollObserver observer_message(const rsi::Outputs& outputs, hal::ResetReason reset_reason) {
    can_dbc::RollObserver message{};
    message.observed_roll_angle_deg = outputs.observed_roll_angle_rad * degrees_per_radian;
    message.observed_bank_angle_deg = outputs.observed_bank_angle_rad * degrees_per_radian;
    message.roll_centre_deviation_m = outputs.roll_centre_deviation_m;
    message.roll_source = static_cast<can_dbc::RollObserver::RollSource>(outputs.roll_source);
    message.roll_sensor_disagrees = (outputs.roll_sensor_disagrees != 0);
    message.estimate_frozen = (outputs.estimate_frozen != 0);
    message.reset_reason = static_cast<can_dbc::RollObserver::ResetReason>(reset_reason);
    return message;
}

static_assert(is_sent_as<hal::ResetReason::power_on, can_dbc::RollObserver::ResetReason::power_on>);
static_assert(is_sent_as<hal::ResetReason::outside, can_dbc::RollObserver::ResetReason::outside>);
static_assert(is_sent_as<hal::ResetReason::undefined_instruction,
                         can_dbc::RollObserver::ResetReason::undefined_instruction>);
static_assert(
    is_sent_as<hal::ResetReason::supervisor_call, can_dbc::RollObserver::ResetReason::supervisor_call>);
static_assert(
    is_sent_as<hal::ResetReason::prefetch_abort, can_dbc::RollObserver::ResetReason::prefetch_abort>);
static_assert(is_sent_as<hal::ResetReason::data_abort, can_dbc::RollObserver::ResetReason::data_abort>);
static_assert(
    is_sent_as<hal::ResetReason::stack_overflow, can_dbc::RollObserver::ResetReason::stack_overflow>);
static_assert(is_sent_as<hal::ResetReason::interrupt, can_dbc::RollObserver::ResetReason::interrupt>);
static_assert(is_sent_as<hal::ResetReason::start_without_reset,
                         can_dbc::RollObserver::ResetReason::start_without_reset>);

static_assert(
    is_sent_as<monitoring::Degradation::unavailable, can_dbc::RolloverDiagnosis::Degradation::unavailable>);
static_assert(is_sent_as<monitoring::Degradation::full, can_dbc::RolloverDiagnosis::Degradation::full>);
static_assert(is_sent_as<monitoring::Degradation::roll_sensor_lost,
                         can_dbc::RolloverDiagnosis::Degradation::roll_sensor_lost>);
static_assert(
    is_sent_as<monitoring::Degradation::motion_lost, can_dbc::RolloverDiagnosis::Degradation::motion_lost>);
static_assert(is_sent_as<monitoring::Degradation::internal_fault,
                         can_dbc::RolloverDiagnosis::Degradation::internal_fault>);
static_assert(is_sent_as<monitoring::EventStatus::none, can_dbc::RolloverDiagnosis::CodeStatus::none>);
static_assert(is_sent_as<monitoring::EventStatus::set, can_dbc::RolloverDiagnosis::CodeStatus::set>);
static_assert(
    is_sent_as<monitoring::EventStatus::confirmed, can_dbc::RolloverDiagnosis::CodeStatus::confirmed>);
static_assert(is_sent_as<monitoring::EventStatus::healed, can_dbc::RolloverDiagnosis::CodeStatus::healed>);
static_assert(is_sent_as<monitoring::DiagnosticCode::none, can_dbc::RolloverDiagnosis::Code::none>);
static_assert(is_sent_as<monitoring::DiagnosticCode::imu_lost, can_dbc::RolloverDiagnosis::Code::imu_lost>);
static_assert(
    is_sent_as<monitoring::DiagnosticCode::imu_damaged, can_dbc::RolloverDiagnosis::Code::imu_damaged>);
static_assert(is_sent_as<monitoring::DiagnosticCode::roll_angle_lost,
                         can_dbc::RolloverDiagnosis::Code::roll_angle_lost>);
static_assert(is_sent_as<monitoring::DiagnosticCode::roll_angle_damaged,
                         can_dbc::RolloverDiagnosis::Code::roll_angle_damaged>);
static_assert(is_sent_as<monitoring::DiagnosticCode::vehicle_motion_lost,
                         can_dbc::RolloverDiagnosis::Code::vehicle_motion_lost>);
static_assert(is_sent_as<monitoring::DiagnosticCode::vehicle_motion_damaged,
                         can_dbc::RolloverDiagnosis::Code::vehicle_motion_damaged>);
static_assert(is_sent_as<monitoring::DiagnosticCode::lateral_acceleration_invalid,
                         can_dbc::RolloverDiagnosis::Code::lateral_acceleration_invalid>);
static_assert(is_sent_as<monitoring::DiagnosticCode::lateral_acceleration_jump,
                         can_dbc::RolloverDiagnosis::Code::lateral_acceleration_jump>);
static_assert(is_sent_as<monitoring::DiagnosticCode::lateral_acceleration_stuck,
                         can_dbc::RolloverDiagnosis::Code::lateral_acceleration_stuck>);
static_assert(is_sent_as<monitoring::DiagnosticCode::vertical_acceleration_invalid,
                         can_dbc::RolloverDiagnosis::Code::vertical_acceleration_invalid>);
static_assert(is_sent_as<monitoring::DiagnosticCode::vertical_acceleration_jump,
                         can_dbc::RolloverDiagnosis::Code::vertical_acceleration_jump>);
static_assert(is_sent_as<monitoring::DiagnosticCode::vertical_acceleration_stuck,
                         can_dbc::RolloverDiagnosis::Code::vertical_acceleration_stuck>);
static_assert(is_sent_as<monitoring::DiagnosticCode::vertical_acceleration_offset,
                         can_dbc::RolloverDiagnosis::Code::vertical_acceleration_offset>);
static_assert(is_sent_as<monitoring::DiagnosticCode::roll_rate_invalid,
                         can_dbc::RolloverDiagnosis::Code::roll_rate_invalid>);
static_assert(
    is_sent_as<monitoring::DiagnosticCode::roll_rate_jump, can_dbc::RolloverDiagnosis::Code::roll_rate_jump>);
static_assert(is_sent_as<monitoring::DiagnosticCode::roll_rate_stuck,
                         can_dbc::RolloverDiagnosis::Code::roll_rate_stuck>);
static_assert(is_sent_as<monitoring::DiagnosticCode::roll_angle_invalid,
                         can_dbc::RolloverDiagnosis::Code::roll_angle_invalid>);
static_assert(is_sent_as<monitoring::DiagnosticCode::roll_angle_jump,
                         can_dbc::RolloverDiagnosis::Code::roll_angle_jump>);
static_assert(is_sent_as<monitoring::DiagnosticCode::roll_angle_stuck,
                         can_dbc::RolloverDiagnosis::Code::roll_angle_stuck>);
static_assert(is_sent_as<monitoring::DiagnosticCode::bank_angle_invalid,
                         can_dbc::RolloverDiagnosis::Code::bank_angle_invalid>);
static_assert(is_sent_as<monitoring::DiagnosticCode::yaw_rate_invalid,
                         can_dbc::RolloverDiagnosis::Code::yaw_rate_invalid>);
static_assert(
    is_sent_as<monitoring::DiagnosticCode::yaw_rate_jump, can_dbc::RolloverDiagnosis::Code::yaw_rate_jump>);
static_assert(
    is_sent_as<monitoring::DiagnosticCode::yaw_rate_stuck, can_dbc::RolloverDiagnosis::Code::yaw_rate_stuck>);
static_assert(
    is_sent_as<monitoring::DiagnosticCode::speed_invalid, can_dbc::RolloverDiagnosis::Code::speed_invalid>);
static_assert(
    is_sent_as<monitoring::DiagnosticCode::speed_jump, can_dbc::RolloverDiagnosis::Code::speed_jump>);
static_assert(
    is_sent_as<monitoring::DiagnosticCode::speed_stuck, can_dbc::RolloverDiagnosis::Code::speed_stuck>);
static_assert(is_sent_as<monitoring::DiagnosticCode::steering_invalid,
                         can_dbc::RolloverDiagnosis::Code::steering_invalid>);
static_assert(
    is_sent_as<monitoring::DiagnosticCode::steering_jump, can_dbc::RolloverDiagnosis::Code::steering_jump>);
static_assert(
    is_sent_as<monitoring::DiagnosticCode::steering_stuck, can_dbc::RolloverDiagnosis::Code::steering_stuck>);
static_assert(is_sent_as<monitoring::DiagnosticCode::roll_rate_contradicts_roll_angle,
                         can_dbc::RolloverDiagnosis::Code::roll_rate_contradicts_roll_angle>);
static_assert(is_sent_as<monitoring::DiagnosticCode::roll_rate_offset,
                         can_dbc::RolloverDiagnosis::Code::roll_rate_offset>);
static_assert(is_sent_as<monitoring::DiagnosticCode::lateral_acceleration_contradicts_yaw_rate,
                         can_dbc::RolloverDiagnosis::Code::lateral_acceleration_contradicts_yaw_rate>);
static_assert(is_sent_as<monitoring::DiagnosticCode::roll_sensor_contradicts_observer,
                         can_dbc::RolloverDiagnosis::Code::roll_sensor_contradicts_observer>);
static_assert(is_sent_as<monitoring::DiagnosticCode::yaw_rate_contradicts_lateral_acceleration,
                         can_dbc::RolloverDiagnosis::Code::yaw_rate_contradicts_lateral_acceleration>);
static_assert(is_sent_as<monitoring::DiagnosticCode::parameters_refused,
                         can_dbc::RolloverDiagnosis::Code::parameters_refused>);
static_assert(is_sent_as<monitoring::DiagnosticCode::parameters_damaged,
                         can_dbc::RolloverDiagnosis::Code::parameters_damaged>);
static_assert(is_sent_as<monitoring::DiagnosticCode::estimate_out_of_range,
                         can_dbc::RolloverDiagnosis::Code::estimate_out_of_range>);
static_assert(is_sent_as<monitoring::DiagnosticCode::output_not_finite,
                         can_dbc::RolloverDiagnosis::Code::output_not_finite>);
static_assert(
    is_sent_as<monitoring::DiagnosticCode::cycle_overrun, can_dbc::RolloverDiagnosis::Code::cycle_overrun>);
static_assert(
    is_sent_as<monitoring::DiagnosticCode::cycle_stall, can_dbc::RolloverDiagnosis::Code::cycle_stall>);
static_assert(
    is_sent_as<monitoring::DiagnosticCode::clock_jump, can_dbc::RolloverDiagnosis::Code::clock_jump>);
static_assert(is_sent_as<monitoring::DiagnosticCode::bus_error, can_dbc::RolloverDiagnosis::Code::bus_error>);
static_assert(is_sent_as<monitoring::DiagnosticCode::receive_overflow,
                         can_dbc::RolloverDiagnosis::Code::receive_overflow>);

can_dbc::RolloverDiagnosis diagnosis_message(const Health& health) {
    const monitoring::DiagnosticRecord& record = health.diagnosis;
    can_dbc::RolloverDiagnosis message{};
    message.degradation = static_cast<can_dbc::RolloverDiagnosis::Degradation>(health.degradation);
    message.code = static_cast<can_dbc::RolloverDiagnosis::Code>(record.code);
    message.code_status = static_cast<can_dbc::RolloverDiagnosis::CodeStatus>(record.status);
    message.occurrences = record.occurrences;
    message.first_lateral_acceleration_mps2 = record.first.lateral_acceleration_mps2;
    message.first_roll_rate_deg_per_s = record.first.roll_rate_radps * degrees_per_radian;
    message.first_roll_angle_deg = record.first.roll_angle_rad * degrees_per_radian;
    message.first_speed_kmh = record.first.speed_mps * kmh_per_mps;
    return message;
}

can_dbc::RolloverStatus status_message(const Health& health) {
    const ReceptionReport& reception = health.reception;
    can_dbc::RolloverStatus message{};
    message.imu_timeout = reception.imu.timeout;
    message.imu_checksum_error = reception.imu.checksum_error;
    message.imu_counter_error = reception.imu.counter_error;
    message.imu_signal_invalid = reception.imu.signal_invalid;
    message.roll_angle_timeout = reception.roll_angle.timeout;
    message.roll_angle_checksum_error = reception.roll_angle.checksum_error;
    message.roll_angle_counter_error = reception.roll_angle.counter_error;
    message.roll_angle_signal_invalid = reception.roll_angle.signal_invalid;
    message.vehicle_motion_timeout = reception.vehicle_motion.timeout;
    message.vehicle_motion_checksum_error = reception.vehicle_motion.checksum_error;
    message.vehicle_motion_counter_error = reception.vehicle_motion.counter_error;
    message.vehicle_motion_signal_invalid = reception.vehicle_motion.signal_invalid;
    message.receive_overflow = health.receive_overflow;
    message.bus_error = health.bus_error;
    message.parameters_invalid = (health.parameters_refusal != ParametersRefusal::none);
    message.cycle_overrun = health.cycle_overrun;
    message.cycle_overruns = saturate(health.cycle_overruns);
    message.frames_rejected = saturate(reception.frames_rejected);
    message.frames_lost = saturate(reception.frames_lost);
    message.software_version = software_version;
    return message;
}

// `frame` is one that all messages take in turn: each is as long as the others, and clearing its 64 bytes for
// every one of them would cost more than filling them.
template <typename Message>
void send_protected(hal::CanBus& bus, const Message& message, can_dbc::e2e::Profile11Sender& sender,
                    hal::CanFrame& frame) {
    std::array<std::uint8_t, Message::length> payload = can_dbc::encode(message);
    sender.protect(payload);
    frame.identifier = Message::identifier;
    frame.extended = Message::extended;
    frame.length = Message::length;
    for (std::size_t index = 0U; index < payload.size(); ++index) {
        frame.data[index] = payload[index];
    }
    static_cast<void>(bus.send(frame));  // the bus counts what it could not send
}

}  // namespace

void WarningTransmission::send(hal::CanBus& bus, const rsi::Outputs& outputs, const Health& health) noexcept {
    hal::CanFrame frame{};
    send_protected(bus, warning_message(outputs, health.parameters_refusal), warning_, frame);
    send_protected(bus, estimate_message(outputs), estimate_, frame);
    send_protected(bus, indices_ahead_message(outputs), indices_ahead_, frame);
    send_protected(bus, indices_classic_message(outputs), indices_classic_, frame);
    send_protected(bus, observer_message(outputs, health.reset_reason), observer_, frame);
    send_protected(bus, diagnosis_message(health), diagnosis_, frame);
    send_protected(bus, status_message(health), status_, frame);
}

}  // namespace application
