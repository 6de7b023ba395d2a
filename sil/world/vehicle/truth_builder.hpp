// Truth builder: states and forces of the vehicle as the quantities that others read: attitude,
// accelerations, wheel loads and roll centres.
#pragma once

#include <limits>

#include "sil/world/vehicle/evaluation.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/state.hpp"
#include "sil/world/vehicle/suspension.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

template <typename Real>
class TruthBuilder {
 public:
    static BasicTruth<Real> build(const BasicVehicleParameters<Real>& parameters,
                                  const BasicFrontWheelPath<Real>& front_path, const BasicState<Real>& state,
                                  const BasicEvaluation<Real>& evaluation) {
        BasicTruth<Real> truth = motion(parameters, state, evaluation);
        write_attitude(evaluation, truth);
        for (std::size_t i = 0; i < wheel_count; ++i) {
            truth.wheel_gap_m[i] = number::max(0.0, -evaluation.wheels[i].deflection_m);
        }
        const Real at_wheel = 0.5 * parameters.geometry.track_width_m *
                              (number::sin(state.suspension[3]) - state.frame_twist_rad);
        truth.suspension_deflection_m = {state.suspension[0], state.suspension[1],
                                         state.suspension[2] + at_wheel, state.suspension[2] - at_wheel};
        const Vector left = evaluation.road_normal.cross(evaluation.heading);
        truth.lateral_tyre_force_n = dot3(product(evaluation.rotation, evaluation.tyre_force_body_n), left);
        truth.roll_centre_height_m = force_based_roll_centre_height(truth, parameters.geometry.track_width_m,
                                                                    evaluation.suspension_roll_moment_nm);
        write_kinematic_roll_centre(front_path, parameters.geometry.track_width_m, state, truth);
        return truth;
    }

    // The part of it that drivers, inertial sensors and judges of a run look at in every step; the rest is no
    // number.
    static BasicTruth<Real> motion(const BasicVehicleParameters<Real>& parameters,
                                   const BasicState<Real>& state, const BasicEvaluation<Real>& evaluation) {
        BasicTruth<Real> truth;
        truth.time_s = state.time_s;
        truth.mass_kg = total_mass_kg(parameters);
        truth.steering_wheel_angle_rad = evaluation.steering_wheel_angle_rad;
        truth.road_wheel_angle_rad = evaluation.road_wheel.angle_rad;
        write_place_and_speed(state, evaluation, truth);
        write_accelerations(state, evaluation, truth);
        for (std::size_t i = 0; i < wheel_count; ++i) {
            truth.wheel_load_n[i] = evaluation.wheels[i].load_n;
            truth.wheel_spin_radps[i] = state.wheel_spin_radps[i];
        }
        truth.pitch_angle_rad = truth.roll_to_horizon_rad = truth.bank_angle_rad = not_defined;
        truth.wheel_gap_m.fill(not_defined);
        truth.suspension_deflection_m.fill(not_defined);
        truth.lateral_tyre_force_n = not_defined;
        truth.roll_centre_height_m = truth.roll_centre_lateral_m = not_defined;
        truth.roll_centre_kinematic_height_m = not_defined;
        return truth;
    }

 private:
    using Vector = Vector3Of<Real>;

    static constexpr double not_defined = std::numeric_limits<double>::quiet_NaN();
    static constexpr double smallest_lateral_force_n = 6000.0;  // below it (24) divides by too little
    static constexpr double smallest_path_slope_sum = 0.02;  // below it the kinematic roll centre is far away

    static void write_place_and_speed(const BasicState<Real>& state, const BasicEvaluation<Real>& evaluation,
                                      BasicTruth<Real>& truth) {
        const Matrix3Of<Real>& rotation = evaluation.rotation;
        const Vector& normal = evaluation.road_normal;
        truth.position_x_m = state.position.x();
        truth.position_y_m = state.position.y();
        truth.position_z_m = state.position.z();
        truth.yaw_angle_rad = number::atan2(evaluation.heading.y(), evaluation.heading.x());
        truth.roll_angle_rad = number::atan2(dot3(rotation.col(1), normal), dot3(rotation.col(2), normal));
        const Vector velocity = product(rotation, state.velocity);
        truth.speed_mps = dot3(velocity, evaluation.heading);
        truth.lateral_velocity_mps = dot3(velocity, normal.cross(evaluation.heading));
    }

    static void write_attitude(const BasicEvaluation<Real>& evaluation, BasicTruth<Real>& truth) {
        const Matrix3Of<Real>& rotation = evaluation.rotation;
        const Vector& normal = evaluation.road_normal;
        const Vector left = normal.cross(evaluation.heading);
        truth.pitch_angle_rad = -number::asin(number::clamp(dot3(rotation.col(0), normal), -1.0, 1.0));
        truth.roll_to_horizon_rad = number::atan2(rotation(2, 1), rotation(2, 2));
        truth.bank_angle_rad = number::atan2(left.z(), normal.z());
    }

    static void write_accelerations(const BasicState<Real>& state, const BasicEvaluation<Real>& evaluation,
                                    BasicTruth<Real>& truth) {
        const BasicAccelerations<Real>& acceleration = evaluation.accelerations;
        const Vector body = acceleration.linear + state.angular_velocity.cross(state.velocity);
        const Vector specific_force = body + gravity_mps2 * evaluation.rotation.row(2).transpose();
        for (int i = 0; i < 3; ++i) {
            const auto index = static_cast<std::size_t>(i);
            truth.angular_velocity_radps[index] = state.angular_velocity[i];
            truth.angular_acceleration_radps2[index] = acceleration.angular[i];
            truth.specific_force_mps2[index] = specific_force[i];
        }
        const Vector earth = product(evaluation.rotation, body);
        const Real heading_x = evaluation.heading.x();
        const Real heading_y = evaluation.heading.y();
        truth.lateral_acceleration_mps2 = (heading_x * earth.y() - heading_y * earth.x()) /
                                          number::max(1e-6, number::hypot(heading_x, heading_y));
    }

    // Equation (24): the load transfer that goes through the links, over the lateral force.
    static Real force_based_roll_centre_height(const BasicTruth<Real>& truth, Real track_width_m,
                                               Real suspension_moment_nm) {
        const auto& load = truth.wheel_load_n;
        const auto all_touch = load[0] > 0.0 && load[1] > 0.0 && load[2] > 0.0 && load[3] > 0.0;
        const auto small_force = number::abs(truth.lateral_tyre_force_n) < smallest_lateral_force_n;
        const Real moment =
            0.5 * track_width_m * (load[front_right] + load[rear_right] - load[front_left] - load[rear_left]);
        return number::choose(!all_touch || small_force, not_defined,
                              (moment - suspension_moment_nm) / truth.lateral_tyre_force_n);
    }

    // Front suspension: each contact's path has an outward slope relative to the road; the lines square to
    // the two paths meet at the roll centre.
    static void write_kinematic_roll_centre(const BasicFrontWheelPath<Real>& path, Real track_width_m,
                                            const BasicState<Real>& state, BasicTruth<Real>& truth) {
        const Real lean = number::tan(truth.roll_angle_rad);
        const Real left_slope = path.slope(state.suspension[0]);
        const Real right_slope = path.slope(state.suspension[1]);
        const Real left = (left_slope - lean) / (1.0 + left_slope * lean);
        const Real right = (right_slope + lean) / (1.0 - right_slope * lean);
        const auto both_touch = truth.wheel_load_n[front_left] > 0.0 && truth.wheel_load_n[front_right] > 0.0;
        const auto undefined = !both_touch || left + right < smallest_path_slope_sum;
        truth.roll_centre_lateral_m =
            number::choose(undefined, not_defined, 0.5 * track_width_m * (right - left) / (left + right));
        truth.roll_centre_kinematic_height_m =
            number::choose(undefined, not_defined, track_width_m * left * right / (left + right));
    }
};

}  // namespace sil
