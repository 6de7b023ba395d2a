// Sensor reception: from frames on the bus to the component's inputs.
#pragma once

#include "rsi/language.hpp"

#include <array>
#include <cstdint>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/ecu/application/frame_delay.hpp"
#include "rsi/ecu/application/frame_monitor.hpp"
#include "rsi/hal/frame_listener.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::application {

// Identifiers for the platform's acceptance filters: those that are received, and those that this control
// unit sends, because a frame with one of them from another node sets the code own_identifier_received.
inline constexpr std::array<std::uint32_t, 4> received_identifiers{
    can_dbc::Imu::identifier, can_dbc::RollAngle::identifier, can_dbc::VehicleMotion::identifier,
    can_dbc::VehicleMass::identifier};
inline constexpr auto sent_identifiers = can_dbc::MessagesFromRolloverEcu::identifiers;

// Limit on the frames read in one cycle, so that a flooded bus cannot exceed the cycle's budget. The rest
// waits.
inline constexpr std::uint32_t most_frames_per_cycle = 64U;

struct ReceptionReport {
    FrameFaults imu{};
    FrameFaults roll_angle{};
    FrameFaults vehicle_motion{};
    bool vehicle_mass_is_fresh{false};       // optional frame, so its absence is no fault
    bool vertical_acceleration_sent{false};  // false: the IMU has always sent "not available"
    bool imu_held_back{false};               // its frames arrive in order, but with a constant delay
    bool own_identifier{false};              // a frame that only this control unit sends came from elsewhere
    std::uint32_t frames_rejected{0U};       // since the start
    std::uint32_t frames_lost{0U};           // since the start, by the E2E counters
    // Latest roll angle while its frames are held back, which keeps it out of the inputs; else NaN.
    float late_roll_angle_rad{rsi::not_available};

    // A fault whose codes are reported only in this case, to keep the usual cycle cheap.
    bool has_rare_fault() const noexcept {
        return own_identifier || imu_held_back || imu.two_senders || roll_angle.two_senders ||
               vehicle_motion.two_senders;
    }
};

// Inputs of a cycle without any available signal.
inline constexpr rsi::Inputs no_inputs{rsi::not_available, rsi::not_available, rsi::not_available,
                                       rsi::not_available, rsi::not_available, rsi::not_available,
                                       rsi::not_available, rsi::not_available, rsi::not_available};

class SensorReception {
 public:
    // Reads which sensors are fitted: frames of others are ignored and never time out.
    void start(const rsi::Parameters& parameters) noexcept {
        roll_angle_fitted_ = (parameters.roll_angle_sensor != RSI_ROLL_SENSOR_NOT_FITTED);
        motion_fitted_ = (parameters.vehicle_motion_sensors != RSI_MOTION_NOT_FITTED);
        steering_fitted_ = (parameters.vehicle_motion_sensors == RSI_MOTION_WITH_STEERING);
    }

    // `listener` gets every standard frame that is not a sensor's. False: there are most_listeners already.
    bool add_listener(hal::FrameListener& listener) noexcept;

    // Reads the waiting frames. `missed_cycles`: number of cycles missed before this one.
    void receive(hal::CanBus& bus, std::uint32_t missed_cycles) noexcept;

    ReceptionReport report(hal::Time now) const noexcept;

    // Time since the newest usable frame of the IMU; before the first one it is of no meaning.
    hal::Time imu_age(hal::Time now) const noexcept { return imu_.age(now); }

    // Latest values in SI units; NaN if the frame is not fresh according to `report`, or the signal not
    // valid.
    rsi::Inputs inputs(const ReceptionReport& report) const noexcept;

 private:
    static constexpr std::size_t most_listeners = 2U;  // XCP and diagnosis

    void dispatch(const hal::CanFrame& frame) noexcept;
    [[gnu::cold]] void take_foreign(const hal::CanFrame& frame) noexcept;
    bool is_roll_angle_fresh(hal::Time now) const noexcept {
        return roll_angle_.is_fresh(now) && !delay_.roll_angle_is_late();
    }

    std::array<hal::FrameListener*, most_listeners> listeners_{};
    FrameMonitor<can_dbc::Imu> imu_{};
    FrameMonitor<can_dbc::RollAngle> roll_angle_{};
    FrameMonitor<can_dbc::VehicleMotion> vehicle_motion_{};
    FrameMonitor<can_dbc::VehicleMass> vehicle_mass_{};
    FrameDelay delay_{};
    bool own_identifier_{false};              // in this cycle
    bool vertical_acceleration_sent_{false};  // since the start
    bool roll_angle_fitted_{true};
    bool motion_fitted_{true};
    bool steering_fitted_{true};
};

}  // namespace rsi::application
