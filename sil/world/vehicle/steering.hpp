// Steering: both front wheels turn together by the handwheel angle over the ratio.
#pragma once

#include <cmath>

#include "sil/world/vehicle/parameters.hpp"

namespace sil {

struct RoadWheelAngle {
    double angle_rad{0.0};
    double sine{0.0};
    double cosine{1.0};
};

inline RoadWheelAngle road_wheel_angle(const SteeringParameters& parameters, double handwheel_rad) {
    const double angle = handwheel_rad / parameters.ratio;
    return {angle, std::sin(angle), std::cos(angle)};
}

}  // namespace sil
