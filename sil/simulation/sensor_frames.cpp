#include "sil/simulation/sensor_frames.hpp"
#include "sil/units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace sil {
namespace {

constexpr double kmh_per_mps = 3.6;

float to_degrees(double radians) {
    return static_cast<float>(radians * degrees_per_radian);
}

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
void SensorFrames::send_protected(rsi::hal::CanBus& bus, const Message& message,
                                  rsi::can_dbc::e2e::Profile11Sender& sender) {
    auto payload = rsi::can_dbc::encode(message);
    sender.protect(payload);
    send_or_throw(bus, to_frame<Message>(payload));
    ++frames_sent_;
}

void SensorFrames::send(rsi::hal::CanBus& bus, const SensorSample& sample) {
    rsi::can_dbc::Imu imu;
    imu.lateral_acceleration_mps2 = static_cast<float>(sample.lateral_acceleration_mps2);
    imu.vertical_acceleration_mps2 = static_cast<float>(sample.vertical_acceleration_mps2);
    imu.roll_rate_deg_per_s = to_degrees(sample.roll_rate_radps);
    send_protected(bus, imu, imu_sender_);

    rsi::can_dbc::RollAngle roll_angle;
    roll_angle.roll_angle_deg = to_degrees(sample.roll_angle_rad);
    roll_angle.bank_angle_deg = to_degrees(sample.bank_angle_rad);
    send_protected(bus, roll_angle, roll_angle_sender_);

    rsi::can_dbc::VehicleMotion motion;
    motion.speed_kmh = static_cast<float>(sample.speed_mps * kmh_per_mps);
    motion.yaw_rate_deg_per_s = to_degrees(sample.yaw_rate_radps);
    motion.steering_wheel_angle_deg = to_degrees(sample.steering_wheel_angle_rad);
    send_protected(bus, motion, vehicle_motion_sender_);

    // Few vehicles have a control unit that sends the mass: without one (NaN) there is no frame.
    if (std::isfinite(sample.vehicle_mass_kg)) {
        rsi::can_dbc::VehicleMass mass;
        mass.mass_kg = static_cast<float>(sample.vehicle_mass_kg);
        send_protected(bus, mass, vehicle_mass_sender_);
    }
}

}  // namespace sil
