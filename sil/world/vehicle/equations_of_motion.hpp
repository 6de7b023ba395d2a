// Equations of motion: the mass matrix as the sum of J^T m J over the bodies, and its solution.
//
// Unknowns are the accelerations of the sprung body (6) and of the suspension coordinates (4: front left
// jounce, front right jounce, axle heave, axle roll), all in body axes with the sprung CG as origin. The
// suspension blocks are small and hardly coupled, so they are eliminated first (Schur complement) and a 6 x 6
// system remains.
#pragma once

#include <array>

#include "sil/world/vehicle/axle.hpp"
#include "sil/world/vehicle/vector.hpp"

namespace sil {

struct Accelerations {
    Vector3 linear{Vector3::Zero()};  // rate of the body-axes velocity components
    Vector3 angular{Vector3::Zero()};
    std::array<double, 4> suspension{};
};

class EquationsOfMotion {
 public:
    // The sprung body alone. `free_acceleration` is gravity less omega x v: what every mass shares.
    EquationsOfMotion(double mass_kg, const Vector3& principal_inertia_kgm2, const Vector3& angular_velocity,
                      const Vector3& free_acceleration);

    // A point mass at `position` that moves by `path` per unit of suspension coordinate `index` (0 or 1), at
    // `rate`; `curvature` is the path's second derivative.
    void add_front_wheel(int index, double mass_kg, const Vector3& position, const Vector3& path,
                         const Vector3& curvature, double rate_mps);

    // The axle: a rod with the given inertia about every line square to it, coordinates 2 and 3.
    void add_rear_axle(double mass_kg, double inertia_kgm2, const AxlePose& pose, double heave_rate_mps,
                       double roll_rate_radps);

    void add_force(const Vector3& force_n, const Vector3& point) {
        force_ += force_n;
        moment_ += point.cross(force_n);
    }
    void add_moment(const Vector3& moment_nm) { moment_ += moment_nm; }
    void add_suspension_force(int index, double generalised_force) {
        suspension_force_[static_cast<std::size_t>(index)] += generalised_force;
    }

    Accelerations solve() const;

 private:
    // Acceleration of a point that moves in the body, apart from the unknown accelerations.
    Vector3 inertial(const Vector3& position, const Vector3& relative_velocity,
                     const Vector3& relative_acceleration) const {
        return angular_velocity_.cross(angular_velocity_.cross(position) + 2.0 * relative_velocity) +
               relative_acceleration;
    }
    void add_mass(double mass_kg, const Vector3& position);

    Vector3 angular_velocity_;
    Vector3 free_acceleration_;
    double mass_;
    Vector3 first_moment_{Vector3::Zero()};
    Matrix3 inertia_;
    Vector3 force_;
    Vector3 moment_;
    std::array<double, 4> suspension_force_{};
    std::array<Vector6, 4> coupling_;  // columns between body and suspension coordinates
    double front_left_mass_{0.0};
    double front_right_mass_{0.0};
    double heave_mass_{0.0};
    double roll_inertia_{0.0};
    double heave_roll_mass_{0.0};
};

}  // namespace sil
