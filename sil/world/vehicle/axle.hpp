// Rear solid axle: where it is in the body for a given heave and roll, located sideways by its Panhard rod.
#pragma once

#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/vector.hpp"

namespace sil {

// The axle turns about the Panhard pivot, which moves up by the heave z and sideways by its lateral path. All
// vectors are in body axes; derivatives are with respect to heave and roll.
struct AxlePose {
    Vector3 centre;
    Vector3 centre_by_heave;
    Vector3 centre_by_roll;
    Vector3 direction;  // along the axle, to the left
    Vector3 upright;    // square to it, up
    double path_curvature_pm{};
    double pivot_m{};

    // The part of the centre's acceleration that comes from the rates alone.
    Vector3 rate_acceleration(double heave_rate_mps, double roll_rate_radps) const {
        const double roll_squared = roll_rate_radps * roll_rate_radps;
        return Vector3{
            0.0, path_curvature_pm * heave_rate_mps * heave_rate_mps - pivot_m * direction.z() * roll_squared,
            pivot_m * direction.y() * roll_squared};
    }
};

class RearAxle {
 public:
    // `centre_at_rest`: of the axle in body axes, in static equilibrium.
    RearAxle(const RearSuspensionParameters& parameters, const Vector3& centre_at_rest)
        : centre_at_rest_{centre_at_rest},
          pivot_m_{parameters.panhard_pivot_m},
          path_slope_{parameters.panhard_slope},
          path_curvature_pm_{1.0 / parameters.panhard_length_m} {}

    AxlePose pose(double heave_m, double roll_rad) const;

 private:
    Vector3 centre_at_rest_;
    double pivot_m_;
    double path_slope_;
    double path_curvature_pm_;
};

}  // namespace sil
