// Rear solid axle: where it is in the body for a given heave and roll, located sideways by its Panhard rod.
#pragma once

#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/vector.hpp"

namespace sil {

// The axle turns about the Panhard pivot, which moves up by the heave z and sideways by its lateral path. All
// vectors are in body axes; derivatives are with respect to heave and roll.
template <typename Real>
struct BasicAxlePose {
    Vector3Of<Real> centre;
    Vector3Of<Real> centre_by_heave;
    Vector3Of<Real> centre_by_roll;
    Vector3Of<Real> direction;  // along the axle, to the left
    Vector3Of<Real> upright;    // square to it, up
    Real path_curvature_pm{};
    Real pivot_m{};

    // The part of the centre's acceleration that comes from the rates alone.
    Vector3Of<Real> rate_acceleration(Real heave_rate_mps, Real roll_rate_radps) const {
        const Real roll_squared = roll_rate_radps * roll_rate_radps;
        return {0.0,
                path_curvature_pm * heave_rate_mps * heave_rate_mps - pivot_m * direction.z() * roll_squared,
                pivot_m * direction.y() * roll_squared};
    }
};

template <typename Real>
class BasicRearAxle {
 public:
    // `centre_at_rest`: of the axle in body axes, in static equilibrium.
    BasicRearAxle(const BasicRearSuspensionParameters<Real>& parameters,
                  const Vector3Of<Real>& centre_at_rest)
        : centre_at_rest_{centre_at_rest},
          pivot_m_{parameters.panhard_pivot_m},
          path_slope_{parameters.panhard_slope},
          path_curvature_pm_{1.0 / parameters.panhard_length_m} {}

    BasicAxlePose<Real> pose(Real heave_m, Real roll_rad) const {
        Real sine;
        Real cosine;
        number::sin_and_cos(roll_rad, sine, cosine);
        const Real lateral = heave_m * (path_slope_ + 0.5 * path_curvature_pm_ * heave_m);
        BasicAxlePose<Real> pose;
        pose.centre = centre_at_rest_ +
                      Vector3Of<Real>{0.0, lateral + pivot_m_ * sine, heave_m + pivot_m_ * (1.0 - cosine)};
        pose.centre_by_heave = Vector3Of<Real>{0.0, path_slope_ + path_curvature_pm_ * heave_m, 1.0};
        pose.centre_by_roll = Vector3Of<Real>{0.0, pivot_m_ * cosine, pivot_m_ * sine};
        pose.direction = Vector3Of<Real>{0.0, cosine, sine};
        pose.upright = Vector3Of<Real>{0.0, -sine, cosine};
        pose.path_curvature_pm = path_curvature_pm_;
        pose.pivot_m = pivot_m_;
        return pose;
    }

 private:
    Vector3Of<Real> centre_at_rest_;
    Real pivot_m_;
    Real path_slope_;
    Real path_curvature_pm_;
};

}  // namespace sil
