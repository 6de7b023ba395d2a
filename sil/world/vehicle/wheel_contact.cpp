// Wheel contact geometry.
#include "sil/world/vehicle/wheel_contact.hpp"

#include <algorithm>
#include <cmath>

namespace sil {
namespace {

constexpr double flattest_upright = 0.2;  // cosine of the camber angle

}  // namespace

WheelContact find_wheel_contact(const Vector3& axis, const Vector3& normal, double clearance_m,
                                double radius_m) {
    WheelContact contact;
    contact.camber = axis.dot(normal);
    const double cosine = std::sqrt(std::max(0.0, 1.0 - contact.camber * contact.camber));
    contact.upright = cosine > flattest_upright;
    const double inverse = 1.0 / std::max(cosine, flattest_upright);
    contact.deflection_m = radius_m * cosine - clearance_m;
    const double loaded_radius = std::clamp(clearance_m * inverse, 0.5 * radius_m, radius_m);
    contact.arm = (contact.camber * axis - normal) * (inverse * loaded_radius);
    contact.forward = axis.cross(normal) * inverse;
    contact.left = normal.cross(contact.forward);
    return contact;
}

}  // namespace sil
