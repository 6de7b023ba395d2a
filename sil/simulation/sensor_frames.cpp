#include "sil/simulation/sensor_frames.hpp"
#include "sil/units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace sil {
namespace {

using rsi::can_dbc::Imu;
using rsi::can_dbc::RollAngle;
using rsi::can_dbc::VehicleMass;
using rsi::can_dbc::VehicleMotion;

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
constexpr std::array<CarriedValue<Imu>, 3U> carried_by<Imu>{{
    {&SensorSample::lateral_acceleration_mps2, &Imu::lateral_acceleration_mps2, 1.0},
    {&SensorSample::vertical_acceleration_mps2, &Imu::vertical_acceleration_mps2, 1.0},
    {&SensorSample::roll_rate_radps, &Imu::roll_rate_deg_per_s, degrees_per_radian},
}};
template <>
constexpr std::array<CarriedValue<RollAngle>, 2U> carried_by<RollAngle>{{
    {&SensorSample::roll_angle_rad, &RollAngle::roll_angle_deg, degrees_per_radian},
    {&SensorSample::bank_angle_rad, &RollAngle::bank_angle_deg, degrees_per_radian},
}};
template <>
constexpr std::array<CarriedValue<VehicleMotion>, 3U> carried_by<VehicleMotion>{{
    {&SensorSample::speed_mps, &VehicleMotion::speed_kmh, 3.6},
    {&SensorSample::yaw_rate_radps, &VehicleMotion::yaw_rate_deg_per_s, degrees_per_radian},
    {&SensorSample::steering_wheel_angle_rad, &VehicleMotion::steering_wheel_angle_deg, degrees_per_radian},
}};
template <>
constexpr std::array<CarriedValue<VehicleMass>, 1U> carried_by<VehicleMass>{{
    {&SensorSample::vehicle_mass_kg, &VehicleMass::mass_kg, 1.0},
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
                                  rsi::can_dbc::e2e::Profile11Sender& sender) {
    Message message;
    for (const CarriedValue<Message>& carried : carried_by<Message>) {
        message.*carried.field = static_cast<float>(sample.*carried.value * carried.units);
    }
    auto payload = rsi::can_dbc::encode(message);
    sender.protect(payload);
    send_or_throw(bus, to_frame<Message>(payload));
    ++frames_sent_;
}

void SensorFrames::send(rsi::hal::CanBus& bus, const SensorSample& sample) {
    send_protected<Imu>(bus, sample, imu_sender_);
    send_protected<RollAngle>(bus, sample, roll_angle_sender_);
    send_protected<VehicleMotion>(bus, sample, vehicle_motion_sender_);
    // Few vehicles have a control unit that sends the mass: without one (NaN) there is no frame.
    if (std::isfinite(sample.vehicle_mass_kg)) {
        send_protected<VehicleMass>(bus, sample, vehicle_mass_sender_);
    }
}

void take_sensor_frame(const rsi::hal::CanFrame& frame, SensorSample& sample) {
    rsi::can_dbc::visit_messages([&](auto type) {
        using Message = typename decltype(type)::Type;
        if (frame.extended != Message::extended || frame.identifier != Message::identifier ||
            frame.length != Message::length) {
            return;
        }
        const Message message = rsi::can_dbc::decode<Message>(frame.data).value;
        for (const CarriedValue<Message>& carried : carried_by<Message>) {
            sample.*carried.value = static_cast<double>(message.*carried.field) / carried.units;
        }
    });
}

}  // namespace sil
