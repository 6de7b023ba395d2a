#include "sil/studies/faults/ecu_answer.hpp"

#include <array>

#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/e2e/profile_11.hpp"

namespace sil {
namespace {

using Status = rsi::can_dbc::RolloverStatus;

struct Flag {
    bool Status::* value;
    const char* name;
};
constexpr std::array flags{
    Flag{&Status::imu_timeout, "ImuTimeout"},
    Flag{&Status::imu_checksum_error, "ImuChecksumError"},
    Flag{&Status::imu_counter_error, "ImuCounterError"},
    Flag{&Status::imu_signal_invalid, "ImuSignalInvalid"},
    Flag{&Status::roll_angle_timeout, "RollAngleTimeout"},
    Flag{&Status::roll_angle_checksum_error, "RollAngleChecksumError"},
    Flag{&Status::roll_angle_counter_error, "RollAngleCounterError"},
    Flag{&Status::roll_angle_signal_invalid, "RollAngleSignalInvalid"},
    Flag{&Status::vehicle_motion_timeout, "VehicleMotionTimeout"},
    Flag{&Status::vehicle_motion_checksum_error, "VehicleMotionChecksumError"},
    Flag{&Status::vehicle_motion_counter_error, "VehicleMotionCounterError"},
    Flag{&Status::vehicle_motion_signal_invalid, "VehicleMotionSignalInvalid"},
    Flag{&Status::receive_overflow, "ReceiveOverflow"},
    Flag{&Status::bus_error, "BusError"},
    Flag{&Status::parameters_invalid, "ParametersInvalid"},
    Flag{&Status::cycle_overrun, "CycleOverrun"},
};
constexpr std::size_t roll_sensor_disagrees_bit = flags.size();

constexpr std::size_t first_code_bit = roll_sensor_disagrees_bit + 1U;
using Diagnosis = rsi::can_dbc::RolloverDiagnosis;

}  // namespace

std::string diagnostic_name(std::size_t index) {
    if (index < flags.size()) {
        return flags[index].name;
    }
    if (index == roll_sensor_disagrees_bit) {
        return "RollSensorDisagrees";
    }
    return Diagnosis::name_of(static_cast<Diagnosis::Code>(index - first_code_bit));
}

std::vector<std::string> diagnostic_names(DiagnosticCodes codes) {
    std::vector<std::string> names;
    for (std::size_t index = 0U; index < codes.size(); ++index) {
        if (codes.test(index)) {
            names.push_back(diagnostic_name(index));
        }
    }
    return names;
}

// A code that the DBC file does not define is decoded as the start value or as "not available", so it does
// not come back.
template <typename Message>
void EcuAnswerReader::take(const rsi::hal::CanFrame& frame, EcuAnswer& answer) {
    ++answer.frames;
    if (rsi::can_dbc::e2e::verify_profile_11(frame.data.data(), frame.length, Message::length,
                                             Message::e2e_data_id) != rsi::can_dbc::e2e::CheckError::none) {
        answer.complete = false;
        return;
    }
    const Message message = rsi::can_dbc::decode<Message>(frame.data).value;
    const auto again = rsi::can_dbc::encode(message);
    for (std::size_t index = rsi::can_dbc::e2e::profile_11_header_length; index < again.size(); ++index) {
        answer.defined = answer.defined && again[index] == frame.data[index];
    }
    keep(message, answer);
}

void EcuAnswerReader::keep(const rsi::can_dbc::RolloverWarning& message, EcuAnswer& answer) const {
    answer.state = message.state;
    answer.side = message.side;
}

void EcuAnswerReader::keep(const rsi::can_dbc::RollObserver& message, EcuAnswer& answer) const {
    answer.roll_source = message.roll_source;
    answer.codes.set(roll_sensor_disagrees_bit, message.roll_sensor_disagrees);
}

void EcuAnswerReader::keep(const rsi::can_dbc::RolloverStatus& message, EcuAnswer& answer) const {
    for (std::size_t index = 0U; index < flags.size(); ++index) {
        answer.codes.set(index, message.*(flags[index].value));
    }
}

void EcuAnswerReader::keep(const rsi::can_dbc::RolloverDiagnosis& message, EcuAnswer& answer) {
    answer.degradation = message.degradation;
    if (message.code == Diagnosis::Code::none) {
        confirmed_.reset();
    } else {
        confirmed_.set(first_code_bit + static_cast<std::size_t>(message.code),
                       message.code_status == Diagnosis::CodeStatus::confirmed);
    }
}

EcuAnswer EcuAnswerReader::read(rsi::hal::CanBus& world) {
    EcuAnswer answer;
    answer.complete = true;
    std::uint32_t seen = 0U;  // one bit a message
    rsi::hal::CanFrame frame;
    while (world.receive(frame) == rsi::hal::ReceiveResult::frame) {
        std::uint32_t message_bit = 1U;
        rsi::can_dbc::MessagesFromRolloverEcu::visit([&](auto type) {
            using Message = typename decltype(type)::Type;
            if (frame.identifier == Message::identifier) {
                answer.complete = answer.complete && (seen & message_bit) == 0U;
                seen |= message_bit;
                take<Message>(frame, answer);
            }
            message_bit <<= 1U;
        });
    }
    answer.codes |= confirmed_;
    answer.complete = answer.complete && seen == (1U << rsi::can_dbc::MessagesFromRolloverEcu::size) - 1U;
    return answer;
}

}  // namespace sil
