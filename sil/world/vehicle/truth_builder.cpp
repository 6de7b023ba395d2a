// Truth builder: attitude, accelerations, wheel loads and roll centres.
#include "sil/world/vehicle/truth_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sil {
namespace {

constexpr double not_defined = std::numeric_limits<double>::quiet_NaN();
constexpr double smallest_lateral_force_n = 6000.0;  // below it (24) divides by too little
constexpr double smallest_path_slope_sum = 0.02;     // below it the kinematic roll centre is far away

void write_attitude(const State& state, const Evaluation& evaluation, Truth& truth) {
    const Matrix3& rotation = evaluation.rotation;
    const Vector3& normal = evaluation.road_normal;
    const Vector3 left = normal.cross(evaluation.heading);
    truth.position_x_m = state.position.x();
    truth.position_y_m = state.position.y();
    truth.position_z_m = state.position.z();
    truth.yaw_angle_rad = std::atan2(evaluation.heading.y(), evaluation.heading.x());
    truth.roll_angle_rad = std::atan2(rotation.col(1).dot(normal), rotation.col(2).dot(normal));
    truth.pitch_angle_rad = -std::asin(std::clamp(rotation.col(0).dot(normal), -1.0, 1.0));
    truth.roll_to_horizon_rad = std::atan2(rotation(2, 1), rotation(2, 2));
    truth.bank_angle_rad = std::atan2(left.z(), normal.z());
    const Vector3 velocity = rotation * state.velocity;
    truth.speed_mps = velocity.dot(evaluation.heading);
    truth.lateral_velocity_mps = velocity.dot(left);
}

void write_accelerations(const State& state, const Evaluation& evaluation, Truth& truth) {
    const Accelerations& acceleration = evaluation.accelerations;
    const Vector3 body = acceleration.linear + state.angular_velocity.cross(state.velocity);
    const Vector3 specific_force = body + gravity_mps2 * evaluation.rotation.row(2).transpose();
    for (int i = 0; i < 3; ++i) {
        const auto index = static_cast<std::size_t>(i);
        truth.angular_velocity_radps[index] = state.angular_velocity[i];
        truth.angular_acceleration_radps2[index] = acceleration.angular[i];
        truth.specific_force_mps2[index] = specific_force[i];
    }
    const Vector3 earth = evaluation.rotation * body;
    const double heading_x = evaluation.heading.x();
    const double heading_y = evaluation.heading.y();
    truth.lateral_acceleration_mps2 =
        (heading_x * earth.y() - heading_y * earth.x()) / std::max(1e-6, std::hypot(heading_x, heading_y));
}

// Equation (24): the load transfer that goes through the links, over the lateral force.
double force_based_roll_centre_height(const Truth& truth, double track_width_m, double suspension_moment_nm) {
    const auto& load = truth.wheel_load_n;
    const bool all_touch = std::all_of(load.begin(), load.end(), [](double n) { return n > 0.0; });
    if (!all_touch || std::abs(truth.lateral_tyre_force_n) < smallest_lateral_force_n) {
        return not_defined;
    }
    const double moment =
        0.5 * track_width_m * (load[front_right] + load[rear_right] - load[front_left] - load[rear_left]);
    return (moment - suspension_moment_nm) / truth.lateral_tyre_force_n;
}

// Front suspension: each contact's path has an outward slope relative to the road; the lines square to the
// two paths meet at the roll centre.
void write_kinematic_roll_centre(const FrontWheelPath& path, double track_width_m, const State& state,
                                 Truth& truth) {
    truth.roll_centre_lateral_m = not_defined;
    truth.roll_centre_kinematic_height_m = not_defined;
    const double lean = std::tan(truth.roll_angle_rad);
    const double left_slope = path.slope(state.suspension[0]);
    const double right_slope = path.slope(state.suspension[1]);
    const double left = (left_slope - lean) / (1.0 + left_slope * lean);
    const double right = (right_slope + lean) / (1.0 - right_slope * lean);
    const bool both_touch = truth.wheel_load_n[front_left] > 0.0 && truth.wheel_load_n[front_right] > 0.0;
    if (!both_touch || left + right < smallest_path_slope_sum) {
        return;
    }
    truth.roll_centre_lateral_m = 0.5 * track_width_m * (right - left) / (left + right);
    truth.roll_centre_kinematic_height_m = track_width_m * left * right / (left + right);
}

}  // namespace

Truth build_truth(const VehicleParameters& parameters, const FrontWheelPath& front_path, const State& state,
                  const Evaluation& evaluation) {
    Truth truth;
    truth.time_s = state.time_s;
    truth.mass_kg = total_mass_kg(parameters);
    truth.steering_wheel_angle_rad = evaluation.steering_wheel_angle_rad;
    truth.road_wheel_angle_rad = evaluation.road_wheel.angle_rad;
    write_attitude(state, evaluation, truth);
    write_accelerations(state, evaluation, truth);
    for (std::size_t i = 0; i < wheel_count; ++i) {
        truth.wheel_load_n[i] = evaluation.wheels[i].load_n;
        truth.wheel_gap_m[i] = std::max(0.0, -evaluation.wheels[i].deflection_m);
        truth.wheel_spin_radps[i] = state.wheel_spin_radps[i];
    }
    const double at_wheel = 0.5 * parameters.geometry.track_width_m * std::sin(state.suspension[3]);
    truth.suspension_deflection_m = {state.suspension[0], state.suspension[1], state.suspension[2] + at_wheel,
                                     state.suspension[2] - at_wheel};
    const Vector3 left = evaluation.road_normal.cross(evaluation.heading);
    truth.lateral_tyre_force_n = (evaluation.rotation * evaluation.tyre_force_body_n).dot(left);
    truth.roll_centre_height_m = force_based_roll_centre_height(truth, parameters.geometry.track_width_m,
                                                                evaluation.suspension_roll_moment_nm);
    write_kinematic_roll_centre(front_path, parameters.geometry.track_width_m, state, truth);
    return truth;
}

}  // namespace sil
