// Wheel contact: where a wheel disc touches the road, and the directions of its tyre forces there.
#pragma once

#include "sil/world/vehicle/vector.hpp"

namespace sil {

// All vectors in body axes.
struct WheelContact {
    Vector3 arm;      // from the wheel's centre to the contact, with the tyre deflected
    Vector3 forward;  // in the road plane
    Vector3 left;
    double deflection_m{};  // < 0 when the wheel is in the air
    double camber{};        // sine of the angle by which the wheel's top leans to the right
    bool upright{};         // false when the disc lies nearly flat on the road and has no tread under it
};

// The lowest point of a disc of the given radius. `axis`: spin axis, unit length, to the left. `clearance_m`:
// height of the wheel's centre over the road along its normal.
WheelContact find_wheel_contact(const Vector3& axis, const Vector3& normal, double clearance_m,
                                double radius_m);

}  // namespace sil
