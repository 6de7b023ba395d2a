// Steering: both front wheels turn together by the handwheel angle over the ratio, at once or with a lag.
#pragma once

#include <cmath>

#include "sil/world/vehicle/parameters.hpp"

namespace sil {

struct RoadWheelAngle {
    double angle_rad{0.0};
    double sine{0.0};
    double cosine{1.0};
};

// The handwheel angle that has reached the wheels a step after `reached_rad` had: column and linkage give
// way.
inline double reached_handwheel_rad(const SteeringParameters& parameters, double reached_rad,
                                    double handwheel_rad, double step_s) {
    if (parameters.lag_s <= 0.0) {
        return handwheel_rad;
    }
    return reached_rad + (handwheel_rad - reached_rad) * step_s / (parameters.lag_s + step_s);
}

inline RoadWheelAngle road_wheel_angle(const SteeringParameters& parameters, double handwheel_rad) {
    const double angle = handwheel_rad / parameters.ratio;
    return {angle, std::sin(angle), std::cos(angle)};
}

}  // namespace sil
