// Equations of motion: the mass matrix as the sum of J^T m J over the bodies, and its solution.
//
// Unknowns are the accelerations of the sprung body (6) and of the suspension coordinates (4: front left
// jounce, front right jounce, axle heave, axle roll), all in body axes with the sprung CG as origin. The
// suspension blocks are small and hardly coupled, so they are eliminated first (Schur complement) and a 6 x 6
// system remains.
#pragma once

#include <array>

#include "sil/world/vehicle/axle.hpp"
#include "sil/world/vehicle/symmetric_solver.hpp"
#include "sil/world/vehicle/vector.hpp"

namespace sil {

template <typename Real>
struct BasicAccelerations {
    Vector3Of<Real> linear{Vector3Of<Real>::Zero()};  // rate of the body-axes velocity components
    Vector3Of<Real> angular{Vector3Of<Real>::Zero()};
    std::array<Real, 4> suspension{};
    Real frame_twist{0.0};
};

template <typename Real>
class EquationsOfMotion {
 public:
    using Vector = Vector3Of<Real>;

    // The sprung body alone. `free_acceleration` is gravity less omega x v: what every mass shares.
    EquationsOfMotion(Real mass_kg, const Vector& principal_inertia_kgm2, const Vector& angular_velocity,
                      const Vector& free_acceleration)
        : angular_velocity_{angular_velocity},
          free_acceleration_{free_acceleration},
          mass_{mass_kg},
          inertia_{principal_inertia_kgm2.asDiagonal()},
          force_{mass_kg * free_acceleration},
          moment_{-angular_velocity.cross(principal_inertia_kgm2.cwiseProduct(angular_velocity))} {}

    // A point mass at `position` that moves by `path` per unit of suspension coordinate `index` (0 or 1), at
    // `rate`; `curvature` is the path's second derivative.
    void add_front_wheel(int index, Real mass_kg, const Vector& position, const Vector& path,
                         const Vector& curvature, Real rate_mps) {
        add_mass(mass_kg, position);
        const Vector force = mass_kg * (free_acceleration_ -
                                        inertial(position, path * rate_mps, curvature * rate_mps * rate_mps));
        add_force(force, position);
        add_suspension_force(index, dot3(path, force));

        couple(index, mass_kg * path, mass_kg * position.cross(path));
        (index == 0 ? front_left_mass_ : front_right_mass_) = mass_kg * dot3(path, path);
    }

    // The axle: a rod with the given inertia about every line square to it, coordinates 2 and 3.
    void add_rear_axle(Real mass_kg, Real inertia_kgm2, const BasicAxlePose<Real>& pose, Real heave_rate_mps,
                       Real roll_rate_radps) {
        add_mass(mass_kg, pose.centre);
        const Vector velocity = pose.centre_by_heave * heave_rate_mps + pose.centre_by_roll * roll_rate_radps;
        const Vector force = mass_kg * (free_acceleration_ -
                                        inertial(pose.centre, velocity,
                                                 pose.rate_acceleration(heave_rate_mps, roll_rate_radps)));
        add_force(force, pose.centre);

        // Inertia of a thin rod along d: J (1 - d d^T), applied to the axle's angular velocity and bias.
        Matrix3Of<Real> inertia;
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                inertia(row, column) = inertia_kgm2 * ((row == column ? 1.0 : 0.0) -
                                                       pose.direction[row] * pose.direction[column]);
            }
        }
        inertia_ += inertia;
        const Vector relative{roll_rate_radps, 0.0, 0.0};
        const Vector axle_angular_velocity = angular_velocity_ + relative;
        const Vector bias = angular_velocity_.cross(relative);
        const Vector moment =
            -(product(inertia, bias) + axle_angular_velocity.cross(product(inertia, axle_angular_velocity)));
        moment_ += moment;

        add_suspension_force(2, dot3(pose.centre_by_heave, force));
        add_suspension_force(3, dot3(pose.centre_by_roll, force) + moment.x());
        couple(2, mass_kg * pose.centre_by_heave, mass_kg * pose.centre.cross(pose.centre_by_heave));
        couple(3, mass_kg * pose.centre_by_roll,
               mass_kg * pose.centre.cross(pose.centre_by_roll) + inertia.col(0));
        heave_mass_ = mass_kg * dot3(pose.centre_by_heave, pose.centre_by_heave);
        roll_inertia_ = mass_kg * dot3(pose.centre_by_roll, pose.centre_by_roll) + inertia(0, 0);
        heave_roll_mass_ = mass_kg * dot3(pose.centre_by_heave, pose.centre_by_roll);
    }

    // A part of the body, whose mass and inertia contain it at `rest`, that turns about a longitudinal line
    // by a coordinate of its own: now at `position`, which moves by `path` per unit of it, with the second
    // derivative `curvature`, at `rate`. `moment` turns it against the body. In those vehicles alone for
    // which it holds.
    template <typename Condition>
    void add_turning_part_if(Condition condition, Real mass_kg, Real inertia_kgm2, const Vector& rest,
                             const Vector& position, const Vector& path, const Vector& curvature,
                             Real rate_radps, Real moment_nm) {
        const EquationsOfMotion before = *this;
        add_mass(mass_kg, position);
        add_mass(-mass_kg, rest);
        const Vector nothing{0.0, 0.0, 0.0};
        const Vector force = mass_kg * (free_acceleration_ - inertial(position, path * rate_radps,
                                                                      curvature * rate_radps * rate_radps));
        add_force(force, position);
        add_force(-mass_kg * (free_acceleration_ - inertial(rest, nothing, nothing)), rest);
        const Real momentum = inertia_kgm2 * rate_radps;  // in which the body turns it
        moment_ += Vector{0.0, -momentum * angular_velocity_.z(), momentum * angular_velocity_.y()};

        something_turns_ = true;
        turning_moment_ = number::choose(condition, dot3(path, force) + moment_nm, Real{0.0});
        turning_coupling_ << mass_kg * path, mass_kg * position.cross(path) + Vector{inertia_kgm2, 0.0, 0.0};
        turning_inertia_ = number::choose(condition, mass_kg * dot3(path, path) + inertia_kgm2, Real{1.0});
        mass_ = number::choose(condition, mass_, before.mass_);
        for (int i = 0; i < 3; ++i) {
            first_moment_[i] = number::choose(condition, first_moment_[i], before.first_moment_[i]);
            force_[i] = number::choose(condition, force_[i], before.force_[i]);
            moment_[i] = number::choose(condition, moment_[i], before.moment_[i]);
            for (int j = 0; j < 3; ++j) {
                inertia_(i, j) = number::choose(condition, inertia_(i, j), before.inertia_(i, j));
            }
        }
        for (int i = 0; i < 6; ++i) {
            turning_coupling_[i] = number::choose(condition, turning_coupling_[i], Real{0.0});
        }
    }

    void add_force(const Vector& force_n, const Vector& point) {
        force_ += force_n;
        moment_ += point.cross(force_n);
    }
    // In those vehicles alone for which it holds.
    template <typename Condition>
    void add_force_if(Condition condition, const Vector& force_n, const Vector& point) {
        const Vector moment = point.cross(force_n);
        for (int i = 0; i < 3; ++i) {
            force_[i] = number::choose(condition, force_[i] + force_n[i], force_[i]);
            moment_[i] = number::choose(condition, moment_[i] + moment[i], moment_[i]);
        }
    }
    template <typename Condition>
    void add_moment_if(Condition condition, const Vector& moment_nm) {
        for (int i = 0; i < 3; ++i) {
            moment_[i] = number::choose(condition, moment_[i] + moment_nm[i], moment_[i]);
        }
    }
    template <typename Condition>
    void add_suspension_force_if(Condition condition, int index, Real generalised_force) {
        Real& sum = suspension_force_[static_cast<std::size_t>(index)];
        sum = number::choose(condition, sum + generalised_force, sum);
    }
    void add_moment(const Vector& moment_nm) { moment_ += moment_nm; }
    void add_suspension_force(int index, Real generalised_force) {
        suspension_force_[static_cast<std::size_t>(index)] += generalised_force;
    }

    BasicAccelerations<Real> solve() const {
        // Lower triangle; the angular momentum's rate under a linear acceleration is first moment x
        // acceleration.
        SymmetricMatrix6<Real> matrix{};
        for (int row = 0; row < 3; ++row) {
            matrix(row, row) = mass_;
            for (int column = 0; column <= row; ++column) {
                matrix(3 + row, 3 + column) = inertia_(row, column);
            }
        }
        matrix(3, 1) = -first_moment_.z();
        matrix(3, 2) = first_moment_.y();
        matrix(4, 0) = first_moment_.z();
        matrix(4, 2) = -first_moment_.x();
        matrix(5, 0) = -first_moment_.y();
        matrix(5, 1) = first_moment_.x();
        Vector6Of<Real> right_hand_side;
        right_hand_side << force_, moment_;

        // Each coordinate's acceleration with the body held, and per unit of the body's acceleration.
        const Real determinant = heave_mass_ * roll_inertia_ - heave_roll_mass_ * heave_roll_mass_;
        const Real by_heave = roll_inertia_ / determinant;
        const Real by_both = -heave_roll_mass_ / determinant;
        const Real by_roll = heave_mass_ / determinant;
        const std::array<Real, 4> held{suspension_force_[0] / front_left_mass_,
                                       suspension_force_[1] / front_right_mass_,
                                       by_heave * suspension_force_[2] + by_both * suspension_force_[3],
                                       by_roll * suspension_force_[3] + by_both * suspension_force_[2]};
        const std::array<Vector6Of<Real>, 4> gain{coupling_[0] / front_left_mass_,
                                                  coupling_[1] / front_right_mass_,
                                                  by_heave * coupling_[2] + by_both * coupling_[3],
                                                  by_roll * coupling_[3] + by_both * coupling_[2]};
        for (std::size_t i = 0; i < 4; ++i) {
            matrix.subtract_product(coupling_[i], gain[i]);
            right_hand_side -= coupling_[i] * held[i];
        }

        Real held_turn{0.0};
        Vector6Of<Real> turn_gain = Vector6Of<Real>::Zero();
        if (something_turns_) {
            held_turn = turning_moment_ / turning_inertia_;
            turn_gain = turning_coupling_ / turning_inertia_;
            matrix.subtract_product(turning_coupling_, turn_gain);
            right_hand_side -= turning_coupling_ * held_turn;
        }

        const Vector6Of<Real> body = solve_positive_definite(matrix, right_hand_side);
        BasicAccelerations<Real> result;
        result.linear = body.template head<3>();
        result.angular = body.template tail<3>();
        for (std::size_t i = 0; i < 4; ++i) {
            result.suspension[i] = held[i] - dot6(gain[i], body);
        }
        if (something_turns_) {
            result.frame_twist = held_turn - dot6(turn_gain, body);
        }
        return result;
    }

 private:
    // Acceleration of a point that moves in the body, apart from the unknown accelerations.
    Vector inertial(const Vector& position, const Vector& relative_velocity,
                    const Vector& relative_acceleration) const {
        const Vector turning = angular_velocity_.cross(position) + 2.0 * relative_velocity;
        return angular_velocity_.cross(turning) + relative_acceleration;
    }

    void add_mass(Real mass_kg, const Vector& position) {
        mass_ += mass_kg;
        const Vector first_moment = mass_kg * position;
        first_moment_ += first_moment;
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                inertia_(row, column) -= first_moment[row] * position[column];
            }
        }
        const Real about_origin = mass_kg * dot3(position, position);
        for (int i = 0; i < 3; ++i) {
            inertia_(i, i) += about_origin;
        }
    }

    void couple(int index, const Vector& linear, const Vector& angular) {
        coupling_[static_cast<std::size_t>(index)] << linear, angular;
    }

    Vector angular_velocity_;
    Vector free_acceleration_;
    Real mass_;
    Vector first_moment_{Vector::Zero()};
    Matrix3Of<Real> inertia_;
    Vector force_;
    Vector moment_;
    std::array<Real, 4> suspension_force_{};
    std::array<Vector6Of<Real>, 4> coupling_;  // columns between body and suspension coordinates
    Real front_left_mass_{0.0};
    Real front_right_mass_{0.0};
    Real heave_mass_{0.0};
    Real roll_inertia_{0.0};
    Real heave_roll_mass_{0.0};
    bool something_turns_{false};
    Real turning_moment_{0.0};
    Vector6Of<Real> turning_coupling_;
    Real turning_inertia_{1.0};
};

}  // namespace sil
