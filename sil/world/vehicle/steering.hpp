// Steering: both front wheels turn together by the handwheel angle over the ratio, at once or with a lag,
// less what the front axle's lateral force turns them back.
#pragma once

#include "sil/world/vehicle/number.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

template <typename Real>
struct BasicRoadWheelAngle {
    Real angle_rad{0.0};
    Real sine{0.0};
    Real cosine{1.0};
};

// The handwheel angle that has reached the wheels a step after `reached_rad` had: column and linkage give
// way.
template <typename Real>
Real reached_handwheel_rad(const BasicSteeringParameters<Real>& parameters, Real reached_rad,
                           Real handwheel_rad, double step_s) {
    return number::choose(parameters.lag_s <= 0.0, handwheel_rad,
                          reached_rad + (handwheel_rad - reached_rad) * step_s / (parameters.lag_s + step_s));
}

template <typename Real>
BasicRoadWheelAngle<Real> road_wheel_angle(const BasicSteeringParameters<Real>& parameters,
                                           Real handwheel_rad, Real front_lateral_n) {
    BasicRoadWheelAngle<Real> angle;
    angle.angle_rad = handwheel_rad / parameters.ratio - parameters.compliance_radpn * front_lateral_n;
    number::sin_and_cos(angle.angle_rad, angle.sine, angle.cosine);
    return angle;
}

}  // namespace sil
