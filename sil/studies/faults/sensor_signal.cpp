#include "sil/studies/faults/sensor_signal.hpp"

#include <algorithm>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double degree = 1.0 / degrees_per_radian;
constexpr double kmh = 1.0 / 3.6;
constexpr std::uint16_t beyond_signed = 0x8001U;
constexpr std::uint16_t beyond_unsigned = 0xFFFEU;

}  // namespace

const std::array<SensorSignal, sensor_signal_count> sensor_signals{{
    {FaultPlace::lateral_acceleration, &SensorSample::lateral_acceleration_mps2,
     rsi::can_dbc::Imu::identifier, 2U, true, beyond_signed, "m/s^2", 1.0, 1.0, 2.0, 0.5, 2.0, 0.2},
    {FaultPlace::vertical_acceleration, &SensorSample::vertical_acceleration_mps2,
     rsi::can_dbc::Imu::identifier, 4U, true, beyond_signed, "m/s^2", 1.0, 1.0, 2.0, 0.5, 2.0, 0.2},
    {FaultPlace::roll_rate, &SensorSample::roll_rate_radps, rsi::can_dbc::Imu::identifier, 6U, true,
     beyond_signed, "deg/s", degree, 5.0, 10.0, 3.0, 10.0, 0.3},
    {FaultPlace::roll_angle, &SensorSample::roll_angle_rad, rsi::can_dbc::RollAngle::identifier, 2U, false,
     beyond_signed, "deg", degree, 2.0, 4.0, 1.0, 3.0, 0.2},
    {FaultPlace::bank_angle, &SensorSample::bank_angle_rad, rsi::can_dbc::RollAngle::identifier, 4U, false,
     beyond_signed, "deg", degree, 3.0, 6.0, 2.0, 4.0, 0.2},
    {FaultPlace::speed, &SensorSample::speed_mps, rsi::can_dbc::VehicleMotion::identifier, 2U, true,
     beyond_unsigned, "km/h", kmh, 15.0, 30.0, 10.0, 20.0, 0.1},
    {FaultPlace::yaw_rate, &SensorSample::yaw_rate_radps, rsi::can_dbc::VehicleMotion::identifier, 4U, true,
     beyond_signed, "deg/s", degree, 5.0, 10.0, 3.0, 10.0, 0.3},
    {FaultPlace::steering_wheel_angle, &SensorSample::steering_wheel_angle_rad,
     rsi::can_dbc::VehicleMotion::identifier, 6U, true, beyond_signed, "deg", degree, 30.0, 60.0, 20.0, 60.0,
     0.1},
}};

// The offset is that of a trailer.
const SensorSignal mass_signal{FaultPlace::vehicle_mass,
                               &SensorSample::vehicle_mass_kg,
                               rsi::can_dbc::VehicleMass::identifier,
                               2U,
                               true,
                               beyond_unsigned,
                               "kg",
                               1.0,
                               100.0,
                               1000.0,
                               50.0,
                               500.0,
                               20.0};

const SensorSignal* find_signal(FaultPlace place) {
    if (place == mass_signal.place) {
        return &mass_signal;
    }
    const auto* const found = std::find_if(sensor_signals.begin(), sensor_signals.end(),
                                           [place](const SensorSignal& each) { return each.place == place; });
    return found == sensor_signals.end() ? nullptr : &*found;
}

std::vector<const SensorSignal*> signals_at(FaultPlace place) {
    std::vector<const SensorSignal*> found;
    const auto add = [&found](std::uint32_t identifier) {
        for (const SensorSignal& each : sensor_signals) {
            if (each.identifier == identifier && each.place != FaultPlace::bank_angle) {
                found.push_back(&each);
            }
        }
    };
    const bool all = place == FaultPlace::all_signals;
    if (all || place == FaultPlace::inertial_signals) {
        add(rsi::can_dbc::Imu::identifier);
    }
    if (all || place == FaultPlace::motion_signals) {
        add(rsi::can_dbc::VehicleMotion::identifier);
    }
    if (all) {
        add(rsi::can_dbc::RollAngle::identifier);
    }
    if (const SensorSignal* const signal = find_signal(place)) {
        found.push_back(signal);
    }
    return found;
}

}  // namespace sil
