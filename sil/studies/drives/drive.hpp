// Drive: the signals of one recorded or simulated drive in SI units, whatever file they came from.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sil/world/vehicle/truth.hpp"

namespace sil {

// Time at the beginning of a drive in which the vehicle stands, or all its wheels are on the road.
inline constexpr double upright_time_s = 1.0;

// Sensor values at one instant, and the wheel loads if they are known. Signs are ISO 8855,
// meanings those of SensorSample. A value that is not available is NaN.
struct DriveSample {
    static constexpr double not_available = std::numeric_limits<double>::quiet_NaN();

    double time_s{not_available};
    double speed_mps{not_available};
    double lateral_specific_force_mps2{not_available};   // f_y, body axes
    double vertical_specific_force_mps2{not_available};  // f_z, body axes, +9.81 at rest
    double roll_rate_radps{not_available};
    double yaw_rate_radps{not_available};
    double roll_angle_rad{not_available};  // of the body, against road or horizon
    double steering_wheel_angle_rad{not_available};
    double bank_angle_rad{not_available};  // of the road, left side up is positive
    double vehicle_mass_kg{not_available};
    // In the order of `Wheel`.
    std::array<double, wheel_count> wheel_load_n{not_available, not_available, not_available, not_available};
};

struct Drive {
    std::string name;                  // of the file, without folder and ending
    std::vector<DriveSample> samples;  // in the order of time, at least two
    // Given with the recorded drive, on its clock; empty also means "did not happen" when
    // lift_off_given.
    std::optional<double> one_wheel_lift_s;
    std::optional<double> two_wheel_lift_s;
    bool lift_off_given{false};
    std::vector<std::string> ignored_columns;  // of the file, for a remark to the user
};

}  // namespace sil
