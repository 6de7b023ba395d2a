// Lift-off: when the wheels of a drive left the road, as far as the drive tells.
#pragma once

#include <optional>

#include "sil/results/ecu_output.hpp"
#include "sil/studies/drives/drive.hpp"

namespace sil {

enum class LiftOffSource : unsigned char { unknown, given, wheel_loads };

struct LiftOff {
    LiftOffSource source{LiftOffSource::unknown};
    std::optional<double> one_wheel_s;  // any wheel; empty also when it did not happen
    std::optional<double> two_wheel_s;  // both wheels of one side (sil/judge/two_wheel_lift.hpp)
    // Side to which the vehicle then falls; none if the wheel loads do not show it.
    WarningSide falling_side{WarningSide::none};
    double up_below_n{0.0};  // a wheel that carries less is up
};

// "given", "wheel loads", "unknown".
const char* to_string(LiftOffSource source);

// A wheel is up at a sample at which it carries less than 1 % of its static load; that is a quarter of the
// vehicle's weight, the median sum of the four loads in the first second. Times that the drive gives win over
// its wheel loads.
LiftOff find_lift_off(const Drive& drive);

// (26): (right - left) / (right + left), > 0 in a left turn; NaN without wheel loads, and in the air.
double load_transfer_ratio(const DriveSample& sample);

}  // namespace sil
