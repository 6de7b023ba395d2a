#include "sil/studies/faults/second_sender.hpp"

#include "can_dbc/codec/message.hpp"
#include "can_dbc/e2e/profile_11.hpp"
#include "can_dbc/generated/rollover_warning.hpp"
#include "sil/simulation/sensor_frames.hpp"

namespace sil {
namespace {

template <typename Message>
hal::CanFrame protected_frame(const Message& message, std::uint8_t counter) {
    auto payload = can_dbc::encode(message);
    can_dbc::e2e::protect_profile_11(payload, Message::e2e_data_id, counter);
    return to_frame<Message>(payload);
}

can_dbc::Imu imu(bool calm) {
    can_dbc::Imu message;
    message.lateral_acceleration_mps2 = calm ? 0.0F : 8.0F;
    message.vertical_acceleration_mps2 = 9.81F;
    message.roll_rate_deg_per_s = calm ? 0.0F : 20.0F;
    return message;
}

can_dbc::RollAngle roll_angle(bool calm) {
    can_dbc::RollAngle message;
    message.roll_angle_deg = calm ? 0.0F : 9.0F;
    return message;
}

can_dbc::VehicleMotion motion(bool calm) {
    can_dbc::VehicleMotion message;
    message.speed_kmh = 100.0F;
    message.yaw_rate_deg_per_s = calm ? 0.0F : 20.0F;
    message.steering_wheel_angle_deg = calm ? 0.0F : 200.0F;
    return message;
}

can_dbc::RolloverWarning warning(bool calm) {
    can_dbc::RolloverWarning message;
    message.state = calm ? can_dbc::RolloverWarning::State::ready : can_dbc::RolloverWarning::State::warning;
    message.side = calm ? can_dbc::RolloverWarning::Side::none : can_dbc::RolloverWarning::Side::right;
    return message;
}

}  // namespace

hal::CanFrame second_senders_frame(FaultPlace place, double magnitude, std::uint8_t counter) {
    const bool calm = magnitude < 0.0;
    switch (place) {
        case FaultPlace::imu_frame:
            return protected_frame(imu(calm), counter);
        case FaultPlace::roll_angle_frame:
            return protected_frame(roll_angle(calm), counter);
        case FaultPlace::vehicle_motion_frame:
            return protected_frame(motion(calm), counter);
        default:
            return protected_frame(warning(calm), counter);
    }
}

}  // namespace sil
