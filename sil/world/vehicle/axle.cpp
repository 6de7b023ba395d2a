// Rear solid axle: pose and its derivatives.
#include "sil/world/vehicle/axle.hpp"

#include <cmath>

namespace sil {

AxlePose RearAxle::pose(double heave_m, double roll_rad) const {
    const double sine = std::sin(roll_rad);
    const double cosine = std::cos(roll_rad);
    const double lateral = heave_m * (path_slope_ + 0.5 * path_curvature_pm_ * heave_m);
    AxlePose pose;
    pose.centre =
        centre_at_rest_ + Vector3{0.0, lateral + pivot_m_ * sine, heave_m + pivot_m_ * (1.0 - cosine)};
    pose.centre_by_heave = Vector3{0.0, path_slope_ + path_curvature_pm_ * heave_m, 1.0};
    pose.centre_by_roll = Vector3{0.0, pivot_m_ * cosine, pivot_m_ * sine};
    pose.direction = Vector3{0.0, cosine, sine};
    pose.upright = Vector3{0.0, -sine, cosine};
    pose.path_curvature_pm = path_curvature_pm_;
    pose.pivot_m = pivot_m_;
    return pose;
}

}  // namespace sil
