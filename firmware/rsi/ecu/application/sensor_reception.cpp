#include "rsi/ecu/application/sensor_reception.hpp"

#include "rsi/hal/saturating_count.hpp"

namespace rsi::application {
namespace {

using can_dbc::SignalStatus;

constexpr float radians_per_degree = 0.017453293F;
constexpr float mps_per_kmh = 1.0F / 3.6F;

template <typename Message>
FrameFaults faults(const FrameMonitor<Message>& monitor, bool fresh, bool signals_valid) {
    return FrameFaults{monitor.received(),       !fresh,
                       monitor.checksum_error(), monitor.counter_error(),
                       fresh && !signals_valid,  monitor.has_two_senders()};
}

constexpr bool is_sent(std::uint32_t identifier) {
    bool sent = false;
    for (const std::uint32_t each : sent_identifiers) {
        sent = sent || (identifier == each);
    }
    return sent;
}

template <typename Message>
void add_counts(const FrameMonitor<Message>& monitor, ReceptionReport& report) {
    hal::count_up(report.frames_rejected, monitor.frames_rejected());
    hal::count_up(report.frames_lost, monitor.frames_lost());
}

}  // namespace

void SensorReception::receive(hal::CanBus& bus, std::uint32_t missed_cycles) noexcept {
    imu_.begin_cycle();
    roll_angle_.begin_cycle();
    vehicle_motion_.begin_cycle();
    vehicle_mass_.begin_cycle();
    if (missed_cycles > 0U) {
        imu_.miss_cycles(missed_cycles);
        roll_angle_.miss_cycles(missed_cycles);
        vehicle_motion_.miss_cycles(missed_cycles);
        vehicle_mass_.miss_cycles(missed_cycles);
        delay_.miss_cycles();
    }
    own_identifier_ = false;
    hal::CanFrame frame{};
    for (std::uint32_t count = 0U; count < most_frames_per_cycle; ++count) {
        if (bus.receive(frame) != hal::ReceiveResult::frame) {
            break;
        }
        dispatch(frame);
    }
    vertical_acceleration_sent_ =
        vertical_acceleration_sent_ ||
        (imu_.latest().status.vertical_acceleration_mps2 != SignalStatus::not_available);
    delay_.update(imu_.latest_counter(), roll_angle_.latest_counter(),
                  roll_angle_.latest().value.roll_angle_deg * radians_per_degree,
                  imu_.latest().value.roll_rate_deg_per_s * radians_per_degree);
}

void SensorReception::dispatch(const hal::CanFrame& frame) noexcept {
    if (frame.extended || frame.flexible_data_rate) {
        return;
    }
    switch (frame.identifier) {
        case can_dbc::Imu::identifier:
            imu_.take(frame);
            break;
        case can_dbc::RollAngle::identifier:
            if (roll_angle_fitted_) {
                roll_angle_.take(frame);
            }
            break;
        case can_dbc::VehicleMotion::identifier:
            if (motion_fitted_) {
                vehicle_motion_.take(frame);
            }
            break;
        case can_dbc::VehicleMass::identifier:
            vehicle_mass_.take(frame);
            break;
        default:
            take_foreign(frame);
            break;
    }
}

// All identifiers that are no sensor's: detects our own sent by another node, and passes the frame to the
// listeners.
void SensorReception::take_foreign(const hal::CanFrame& frame) noexcept {
    own_identifier_ = own_identifier_ || is_sent(frame.identifier);
    for (hal::FrameListener* const listener : listeners_) {
        if (listener != nullptr) {
            listener->take(frame);
        }
    }
}

bool SensorReception::add_listener(hal::FrameListener& listener) noexcept {
    for (hal::FrameListener*& place : listeners_) {
        if (place == nullptr) {
            place = &listener;
            return true;
        }
    }
    return false;
}

// The codec decodes an invalid signal as NaN, which means "not available" to the component.
rsi::Inputs SensorReception::inputs(const ReceptionReport& report) const noexcept {
    const can_dbc::Imu imu = report.imu.is_fresh() ? imu_.latest().value : can_dbc::Imu{};
    const can_dbc::RollAngle roll =
        report.roll_angle.is_fresh() ? roll_angle_.latest().value : can_dbc::RollAngle{};
    const can_dbc::VehicleMotion motion =
        report.vehicle_motion.is_fresh() ? vehicle_motion_.latest().value : can_dbc::VehicleMotion{};
    const can_dbc::VehicleMass mass =
        report.vehicle_mass_is_fresh ? vehicle_mass_.latest().value : can_dbc::VehicleMass{};
    // A code beyond the range is a mass that no vehicle has, unlike one that is not available.
    const bool mass_is_impossible =
        report.vehicle_mass_is_fresh && (vehicle_mass_.latest().status.mass_kg == SignalStatus::out_of_range);

    rsi::Inputs inputs{};
    inputs.lateral_specific_force_mps2 = imu.lateral_acceleration_mps2;
    inputs.vertical_specific_force_mps2 = imu.vertical_acceleration_mps2;
    inputs.roll_rate_radps = imu.roll_rate_deg_per_s * radians_per_degree;
    inputs.roll_angle_rad = roll.roll_angle_deg * radians_per_degree;
    inputs.bank_angle_rad = roll.bank_angle_deg * radians_per_degree;
    inputs.yaw_rate_radps = motion.yaw_rate_deg_per_s * radians_per_degree;
    inputs.speed_mps = motion.speed_kmh * mps_per_kmh;
    inputs.steering_wheel_angle_rad =
        steering_fitted_ ? motion.steering_wheel_angle_deg * radians_per_degree : rsi::not_available;
    inputs.vehicle_mass_kg = mass_is_impossible ? 0.0F : mass.mass_kg;
    return inputs;
}

ReceptionReport SensorReception::report(hal::Time now) const noexcept {
    const can_dbc::RollAngle::Status& roll = roll_angle_.latest().status;
    // Most vehicles have no bank sensor, so an unavailable bank angle is no fault.
    const bool roll_valid =
        (roll.roll_angle_deg == SignalStatus::valid) && (roll.bank_angle_deg != SignalStatus::out_of_range);
    const can_dbc::Imu::Status& imu = imu_.latest().status;
    const bool imu_valid =
        (imu.lateral_acceleration_mps2 == SignalStatus::valid) &&
        (imu.roll_rate_deg_per_s == SignalStatus::valid) &&
        (!vertical_acceleration_sent_ || (imu.vertical_acceleration_mps2 == SignalStatus::valid));
    const can_dbc::VehicleMotion::Status& motion = vehicle_motion_.latest().status;
    const bool motion_valid = (motion.speed_kmh == SignalStatus::valid) &&
                              (motion.yaw_rate_deg_per_s == SignalStatus::valid) &&
                              (!steering_fitted_ || (motion.steering_wheel_angle_deg == SignalStatus::valid));

    ReceptionReport report{};
    report.imu = faults(imu_, imu_.is_fresh(now), imu_valid);
    if (roll_angle_fitted_) {
        report.roll_angle = faults(roll_angle_, is_roll_angle_fresh(now), roll_valid);
    }
    if (motion_fitted_) {
        report.vehicle_motion = faults(vehicle_motion_, vehicle_motion_.is_fresh(now), motion_valid);
    }
    report.vertical_acceleration_sent = vertical_acceleration_sent_;
    report.imu_held_back = delay_.imu_is_late();
    report.own_identifier = own_identifier_;
    report.vehicle_mass_is_fresh = vehicle_mass_.is_fresh(now);
    if (delay_.roll_angle_is_late() && roll_angle_.is_fresh(now)) {
        report.late_roll_angle_rad = roll_angle_.latest().value.roll_angle_deg * radians_per_degree;
    }
    add_counts(imu_, report);
    add_counts(roll_angle_, report);
    add_counts(vehicle_motion_, report);
    add_counts(vehicle_mass_, report);
    return report;
}

}  // namespace rsi::application
