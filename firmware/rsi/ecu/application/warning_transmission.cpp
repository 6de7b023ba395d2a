#include "rsi/ecu/application/warning_transmission.hpp"

#include <cstring>

#include "rsi/version.h"

namespace rsi::application {
namespace {

// Major and minor number; a patch does not change the interface.
constexpr std::uint8_t software_version = RSI_VERSION_BYTE;

std::uint8_t saturate(std::uint32_t count) {
    return (count < 255U) ? static_cast<std::uint8_t>(count) : std::uint8_t{255U};
}

constexpr float degrees_per_radian = 57.295780F;
constexpr float kmh_per_mps = 3.6F;

// Fills the signals that do not come from rsi_outputs; most messages have none. The casts rely on equal
// enumerators in firmware and DBC file, which tests/can_dbc/enumerators_test.py compares.
template <typename Message>
void fill(Message&, const Health&) {}

void fill(can_dbc::RolloverWarning& message, const Health& health) {
    message.parameters_refusal =
        static_cast<can_dbc::RolloverWarning::ParametersRefusal>(health.parameters_refusal);
}

void fill(can_dbc::RollObserver& message, const Health& health) {
    message.reset_reason = static_cast<can_dbc::RollObserver::ResetReason>(health.reset_reason);
    message.protection = static_cast<can_dbc::RollObserver::Protection>(health.protection);
}

void fill(can_dbc::RolloverDiagnosis& message, const Health& health) {
    const monitoring::DiagnosticRecord& record = health.diagnosis;
    message.degradation = static_cast<can_dbc::RolloverDiagnosis::Degradation>(health.degradation);
    message.code = static_cast<can_dbc::RolloverDiagnosis::Code>(record.code);
    message.code_status = static_cast<can_dbc::RolloverDiagnosis::CodeStatus>(record.status);
    message.occurrences = record.occurrences;
    message.first_lateral_acceleration_mps2 = record.first.lateral_acceleration_mps2;
    message.first_roll_rate_deg_per_s = record.first.roll_rate_radps * degrees_per_radian;
    message.first_roll_angle_deg = record.first.roll_angle_rad * degrees_per_radian;
    message.first_speed_kmh = record.first.speed_mps * kmh_per_mps;
}

void fill(can_dbc::RolloverStatus& message, const Health& health) {
    const ReceptionReport& reception = health.reception;
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
    message.parameters_invalid = health.parameters_invalid;
    message.cycle_overrun = health.cycle_overrun;
    message.cycle_overruns = saturate(health.cycle_overruns);
    message.frames_rejected = saturate(reception.frames_rejected);
    message.frames_lost = saturate(reception.frames_lost);
    message.software_version = software_version;
}

// `frame` is a buffer reused by all messages, which have the same length: clearing its 64 bytes for each
// would cost more than filling them.
template <typename Message>
void send_protected(hal::CanBus& bus, const Message& message, can_dbc::e2e::Profile11Sender& sender,
                    hal::CanFrame& frame) {
    std::array<std::uint8_t, Message::length> payload = can_dbc::encode(message);
    sender.protect(payload);
    frame.identifier = Message::identifier;
    frame.extended = Message::extended;
    frame.length = Message::length;
    std::memcpy(frame.data.data(), payload.data(), payload.size());
    static_cast<void>(bus.send(frame));  // the bus counts what it could not send
}

template <typename Message>
Message message_of(const rsi::Outputs& outputs, const Health& health) {
    Message message{};
    if constexpr (Message::has_sources) {
        message.take(outputs);
    }
    fill(message, health);
    return message;
}

}  // namespace

template <typename... Messages>
void WarningTransmission::Senders<can_dbc::MessageList<Messages...>>::send(hal::CanBus& bus,
                                                                           const rsi::Outputs& outputs,
                                                                           const Health& health) noexcept {
    hal::CanFrame frame{};
    (send_protected(bus, message_of<Messages>(outputs, health), SenderOf<Messages>::sender, frame), ...);
}

void WarningTransmission::send(hal::CanBus& bus, const rsi::Outputs& outputs, const Health& health) noexcept {
    senders_.send(bus, outputs, health);
}

}  // namespace rsi::application
