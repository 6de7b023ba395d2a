// Equations of motion: assembly body by body, elimination of the suspension coordinates, solution.
#include "sil/world/vehicle/equations_of_motion.hpp"

#include "sil/world/vehicle/symmetric_solver.hpp"

namespace sil {

EquationsOfMotion::EquationsOfMotion(double mass_kg, const Vector3& principal_inertia_kgm2,
                                     const Vector3& angular_velocity, const Vector3& free_acceleration)
    : angular_velocity_{angular_velocity},
      free_acceleration_{free_acceleration},
      mass_{mass_kg},
      inertia_{principal_inertia_kgm2.asDiagonal()},
      force_{mass_kg * free_acceleration},
      moment_{-angular_velocity.cross(principal_inertia_kgm2.cwiseProduct(angular_velocity))} {}

void EquationsOfMotion::add_mass(double mass_kg, const Vector3& position) {
    mass_ += mass_kg;
    first_moment_ += mass_kg * position;
    inertia_ -= (mass_kg * position) * position.transpose();
    inertia_.diagonal().array() += mass_kg * position.squaredNorm();
}

void EquationsOfMotion::add_front_wheel(int index, double mass_kg, const Vector3& position,
                                        const Vector3& path, const Vector3& curvature, double rate_mps) {
    add_mass(mass_kg, position);
    const Vector3 force =
        mass_kg * (free_acceleration_ - inertial(position, path * rate_mps, curvature * rate_mps * rate_mps));
    add_force(force, position);
    add_suspension_force(index, path.dot(force));

    coupling_[static_cast<std::size_t>(index)] << mass_kg * path, mass_kg * position.cross(path);
    (index == 0 ? front_left_mass_ : front_right_mass_) = mass_kg * path.squaredNorm();
}

void EquationsOfMotion::add_rear_axle(double mass_kg, double inertia_kgm2, const AxlePose& pose,
                                      double heave_rate_mps, double roll_rate_radps) {
    add_mass(mass_kg, pose.centre);
    const Vector3 velocity = pose.centre_by_heave * heave_rate_mps + pose.centre_by_roll * roll_rate_radps;
    const Vector3 force =
        mass_kg * (free_acceleration_ -
                   inertial(pose.centre, velocity, pose.rate_acceleration(heave_rate_mps, roll_rate_radps)));
    add_force(force, pose.centre);

    // Inertia of a thin rod along d: J (1 - d d^T), applied to the axle's angular velocity and bias.
    const Matrix3 inertia =
        inertia_kgm2 * (Matrix3::Identity() - pose.direction * pose.direction.transpose());
    inertia_ += inertia;
    const Vector3 relative = Vector3::UnitX() * roll_rate_radps;
    const Vector3 axle_angular_velocity = angular_velocity_ + relative;
    const Vector3 moment = -(inertia * angular_velocity_.cross(relative) +
                             axle_angular_velocity.cross(inertia * axle_angular_velocity));
    moment_ += moment;

    add_suspension_force(2, pose.centre_by_heave.dot(force));
    add_suspension_force(3, pose.centre_by_roll.dot(force) + moment.x());
    coupling_[2] << mass_kg * pose.centre_by_heave, mass_kg * pose.centre.cross(pose.centre_by_heave);
    coupling_[3] << mass_kg * pose.centre_by_roll,
        mass_kg * pose.centre.cross(pose.centre_by_roll) + inertia.col(0);
    heave_mass_ = mass_kg * pose.centre_by_heave.squaredNorm();
    roll_inertia_ = mass_kg * pose.centre_by_roll.squaredNorm() + inertia(0, 0);
    heave_roll_mass_ = mass_kg * pose.centre_by_heave.dot(pose.centre_by_roll);
}

Accelerations EquationsOfMotion::solve() const {
    // Lower triangle; the angular momentum's rate under a linear acceleration is first moment x acceleration.
    SymmetricMatrix6 matrix{};
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
    Vector6 right_hand_side;
    right_hand_side << force_, moment_;

    // Each coordinate's acceleration with the body held, and per unit of the body's acceleration.
    const double determinant = heave_mass_ * roll_inertia_ - heave_roll_mass_ * heave_roll_mass_;
    const double by_heave = roll_inertia_ / determinant;
    const double by_both = -heave_roll_mass_ / determinant;
    const double by_roll = heave_mass_ / determinant;
    const std::array<double, 4> held{suspension_force_[0] / front_left_mass_,
                                     suspension_force_[1] / front_right_mass_,
                                     by_heave * suspension_force_[2] + by_both * suspension_force_[3],
                                     by_roll * suspension_force_[3] + by_both * suspension_force_[2]};
    const std::array<Vector6, 4> gain{coupling_[0] / front_left_mass_, coupling_[1] / front_right_mass_,
                                      by_heave * coupling_[2] + by_both * coupling_[3],
                                      by_roll * coupling_[3] + by_both * coupling_[2]};
    for (std::size_t i = 0; i < 4; ++i) {
        matrix.subtract_product(coupling_[i], gain[i]);
        right_hand_side -= coupling_[i] * held[i];
    }

    const Vector6 body = solve_positive_definite(matrix, right_hand_side);
    Accelerations result;
    result.linear = body.head<3>();
    result.angular = body.tail<3>();
    for (std::size_t i = 0; i < 4; ++i) {
        result.suspension[i] = held[i] - gain[i].dot(body);
    }
    return result;
}

}  // namespace sil
