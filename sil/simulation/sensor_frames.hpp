// Sensor frames: the frames of the vehicle's sensors, with end-to-end protection.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/hal/can_bus.hpp"
#include "sil/world/sensors/sensor_sample.hpp"

namespace sil {

// A classic frame with this message's identifier and an encoded payload.
template <typename Message>
rsi::hal::CanFrame to_frame(const std::array<std::uint8_t, Message::length>& payload) {
    rsi::hal::CanFrame frame;
    frame.identifier = Message::identifier;
    frame.extended = Message::extended;
    frame.length = Message::length;
    std::copy(payload.begin(), payload.end(), frame.data.begin());
    return frame;
}

// Throws std::runtime_error when the bus does not take the frame.
void send_or_throw(rsi::hal::CanBus& bus, const rsi::hal::CanFrame& frame);

// Takes over the values of a sensor frame, whose end-to-end protection is left to the firmware; other frames
// change nothing.
void take_sensor_frame(const rsi::hal::CanFrame& frame, SensorSample& sample);

class SensorFrames {
 public:
    // Sends one sample as the frames Imu, RollAngle and VehicleMotion, and VehicleMass if the sample has a
    // mass. A NaN is sent as "not available". Throws std::runtime_error when the bus does not take a frame.
    void send(rsi::hal::CanBus& bus, const SensorSample& sample);

    std::uint64_t frames_sent() const { return frames_sent_; }

 private:
    template <typename Message>
    void send_protected(rsi::hal::CanBus& bus, const SensorSample& sample,
                        rsi::can_dbc::e2e::Profile11Sender& sender);

    rsi::can_dbc::e2e::Profile11Sender imu_sender_{rsi::can_dbc::Imu::e2e_data_id};
    rsi::can_dbc::e2e::Profile11Sender roll_angle_sender_{rsi::can_dbc::RollAngle::e2e_data_id};
    rsi::can_dbc::e2e::Profile11Sender vehicle_motion_sender_{rsi::can_dbc::VehicleMotion::e2e_data_id};
    rsi::can_dbc::e2e::Profile11Sender vehicle_mass_sender_{rsi::can_dbc::VehicleMass::e2e_data_id};
    std::uint64_t frames_sent_{0U};
};

}  // namespace sil
