// Sensor reception: from frames on the bus to the component's inputs.
#pragma once

#include <array>
#include <cstdint>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/ecu/application/frame_delay.hpp"
#include "rsi/ecu/application/frame_monitor.hpp"
#include "rsi/hal/frame_listener.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::application {

// A platform lets these identifiers through its acceptance filters, and those that this control unit sends,
// sent_identifiers, when another node sends them.
inline constexpr std::array<std::uint32_t, 4> received_identifiers{
    can_dbc::Imu::identifier, can_dbc::RollAngle::identifier, can_dbc::VehicleMotion::identifier,
    can_dbc::VehicleMass::identifier};
inline constexpr auto sent_identifiers = can_dbc::MessagesFromRolloverEcu::identifiers;

// Not more frames than this are read in one cycle, so that a flood cannot stop the cycle. The rest waits.
inline constexpr std::uint32_t most_frames_per_cycle = 64U;

struct ReceptionReport {
    FrameFaults imu{};
    FrameFaults roll_angle{};
    FrameFaults vehicle_motion{};
    bool vehicle_mass_is_fresh{false};       // few vehicles send it
    bool vertical_acceleration_sent{false};  // an IMU without one says "not available" all the time
    bool imu_held_back{false};               // its frames come in order, but late all the time
    bool own_identifier{false};              // a frame that only this control unit sends came from elsewhere
    std::uint32_t frames_rejected{0U};       // since the start
    std::uint32_t frames_lost{0U};           // since the start, by the counters
    // The newest roll angle while it is held back, and for that not among the inputs; else NaN.
    float late_roll_angle_rad{rsi::not_available};

    // One whose absence is no fault.
    bool has_rare_fault() const noexcept {
        return own_identifier || imu_held_back || imu.two_senders || roll_angle.two_senders ||
               vehicle_motion.two_senders;
    }
};

// A cycle in which nothing is known.
inline constexpr rsi::Inputs no_inputs{rsi::not_available, rsi::not_available, rsi::not_available,
                                       rsi::not_available, rsi::not_available, rsi::not_available,
                                       rsi::not_available, rsi::not_available, rsi::not_available};

class SensorReception {
 public:
    // Which sensors the vehicle has: frames of others are not read, and not missed.
    void start(const rsi::Parameters& parameters) noexcept {
        roll_angle_fitted_ = (parameters.roll_angle_sensor != RSI_ROLL_SENSOR_NOT_FITTED);
        motion_fitted_ = (parameters.vehicle_motion_sensors != RSI_MOTION_NOT_FITTED);
        steering_fitted_ = (parameters.vehicle_motion_sensors == RSI_MOTION_WITH_STEERING);
    }

    // Others than this control unit's own frames are passed on. False: there are most_listeners already.
    bool listen(hal::FrameListener& listener) noexcept;

    // Reads what waits on the bus. `missed_cycles` were left out before this one.
    void receive(hal::CanBus& bus, std::uint32_t missed_cycles) noexcept;

    ReceptionReport report(hal::Time now) const noexcept;

    // The newest values in SI units; NaN where a frame is not fresh, by that report, or a signal not valid.
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
    FrameMonitor<can_dbc::VehicleMass> vehicle_mass_{};  // few vehicles send it, so its absence is no fault
    FrameDelay delay_{};
    bool own_identifier_{false};              // in this cycle
    bool vertical_acceleration_sent_{false};  // since the start
    bool roll_angle_fitted_{true};
    bool motion_fitted_{true};
    bool steering_fitted_{true};
};

}  // namespace rsi::application
