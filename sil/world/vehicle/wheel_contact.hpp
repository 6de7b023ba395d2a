// Wheel contact: where a wheel disc touches the road, and the directions of its tyre forces there.
#pragma once

#include "sil/world/vehicle/vector.hpp"

namespace sil {

// All vectors in body axes.
template <typename Real>
struct BasicWheelContact {
    Vector3Of<Real> arm;      // from the wheel's centre to the contact, with the tyre deflected
    Vector3Of<Real> forward;  // in the road plane
    Vector3Of<Real> left;
    Real deflection_m{};  // < 0 when the wheel is in the air
    Real camber{};        // sine of the angle by which the wheel's top leans to the right
    Real cosine{};        // of that angle

    // If it does not hold, the disc lies nearly flat on the road and has no tread under it.
    auto upright() const { return cosine > flattest_upright; }

    static constexpr double flattest_upright = 0.2;
};
using WheelContact = BasicWheelContact<double>;

// The lowest point of a disc of the given radius. `axis`: spin axis, unit length, to the left. `clearance_m`:
// height of the wheel's centre over the road along its normal.
template <typename Real>
BasicWheelContact<Real> find_wheel_contact(const Vector3Of<Real>& axis, const Vector3Of<Real>& normal,
                                           Real clearance_m, Real radius_m) {
    BasicWheelContact<Real> contact;
    contact.camber = dot3(axis, normal);
    contact.cosine = number::sqrt(number::max(0.0, 1.0 - contact.camber * contact.camber));
    const Real inverse = 1.0 / number::max(contact.cosine, contact.flattest_upright);
    contact.deflection_m = radius_m * contact.cosine - clearance_m;
    const Real loaded_radius = number::clamp(clearance_m * inverse, 0.5 * radius_m, radius_m);
    contact.arm = (contact.camber * axis - normal) * (inverse * loaded_radius);
    contact.forward = axis.cross(normal) * inverse;
    contact.left = normal.cross(contact.forward);
    return contact;
}

}  // namespace sil
