#include "sil/simulation/sensor_frames.hpp"
#include "sil/units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace sil {
namespace {

namespace dbc = rsi::can_dbc;

// A value of a sample, the field of a frame that carries it, and the field's units in one of the value's.
template <typename Message>
struct CarriedValue {
    double SensorSample::* value;
    float Message::* field;
    double units;
};

template <typename Message>
constexpr std::array<CarriedValue<Message>, 0U> carried_by{};
template <>
constexpr std::array<CarriedValue<dbc::Imu>, 3U> carried_by<dbc::Imu>{{
    {&SensorSample::lateral_acceleration_mps2, &dbc::Imu::lateral_acceleration_mps2, 1.0},
    {&SensorSample::vertical_acceleration_mps2, &dbc::Imu::vertical_acceleration_mps2, 1.0},
    {&SensorSample::roll_rate_radps, &dbc::Imu::roll_rate_deg_per_s, degrees_per_radian},
}};
template <>
constexpr std::array<CarriedValue<dbc::RollAngle>, 2U> carried_by<dbc::RollAngle>{{
    {&SensorSample::roll_angle_rad, &dbc::RollAngle::roll_angle_deg, degrees_per_radian},
    {&SensorSample::bank_angle_rad, &dbc::RollAngle::bank_angle_deg, degrees_per_radian},
}};
template <>
constexpr std::array<CarriedValue<dbc::VehicleMotion>, 3U> carried_by<dbc::VehicleMotion>{{
    {&SensorSample::speed_mps, &dbc::VehicleMotion::speed_kmh, 3.6},
    {&SensorSample::yaw_rate_radps, &dbc::VehicleMotion::yaw_rate_deg_per_s, degrees_per_radian},
    {&SensorSample::steering_wheel_angle_rad, &dbc::VehicleMotion::steering_wheel_angle_deg,
     degrees_per_radian},
}};
template <>
constexpr std::array<CarriedValue<dbc::VehicleMass>, 1U> carried_by<dbc::VehicleMass>{{
    {&SensorSample::vehicle_mass_kg, &dbc::VehicleMass::mass_kg, 1.0},
}};

}  // namespace

void send_or_throw(rsi::hal::CanBus& bus, const rsi::hal::CanFrame& frame) {
    const rsi::hal::SendResult result = bus.send(frame);
    if (result != rsi::hal::SendResult::sent) {
        throw std::runtime_error(fmt::format(
            "frame 0x{:03X} could not be sent: {}. Check that the interface is up and that its queue is not "
            "full "
            "(ip -details link show).",
            frame.identifier,
            result == rsi::hal::SendResult::full ? "the send queue is full" : "the bus has failed"));
    }
}

template <typename Message>
void SensorFrames::send_protected(rsi::hal::CanBus& bus, const SensorSample& sample,
                                  dbc::e2e::Profile11Sender& sender) {
    Message message;
    for (const CarriedValue<Message>& carried : carried_by<Message>) {
        message.*carried.field = static_cast<float>(sample.*carried.value * carried.units);
    }
    auto payload = dbc::encode(message);
    sender.protect(payload);
    send_or_throw(bus, to_frame<Message>(payload));
    ++frames_sent_;
}

void SensorFrames::send(rsi::hal::CanBus& bus, const SensorSample& sample) {
    send_protected<dbc::Imu>(bus, sample, imu_sender_);
    send_protected<dbc::RollAngle>(bus, sample, roll_angle_sender_);
    send_protected<dbc::VehicleMotion>(bus, sample, vehicle_motion_sender_);
    // Few vehicles have a control unit that sends the mass: without one (NaN) there is no frame.
    if (std::isfinite(sample.vehicle_mass_kg)) {
        send_protected<dbc::VehicleMass>(bus, sample, vehicle_mass_sender_);
    }
}

void take_sensor_frame(const rsi::hal::CanFrame& frame, SensorSample& sample) {
    dbc::visit_messages([&](auto type) {
        using Message = typename decltype(type)::Type;
        if (frame.extended != Message::extended || frame.identifier != Message::identifier ||
            frame.length != Message::length) {
            return;
        }
        const Message message = dbc::decode<Message>(frame.data).value;
        for (const CarriedValue<Message>& carried : carried_by<Message>) {
            sample.*carried.value = static_cast<double>(message.*carried.field) / carried.units;
        }
    });
}

}  // namespace sil
