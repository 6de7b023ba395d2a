// Drive: the signals of one recorded or simulated drive in SI units, whatever file they came from.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sil/world/sensors/sensor_sample.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

// Time at the beginning of a drive in which the vehicle stands, or all its wheels are on the road.
inline constexpr double upright_time_s = 1.0;

// A sample of the sensors, and the wheel loads if they are known. A value that is not available is NaN.
struct DriveSample : SensorSample {
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
