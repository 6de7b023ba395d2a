// Vehicle: one model on its road, and how it is put there.
#include "sil/world/vehicle/vehicle.hpp"

#include <cmath>

namespace sil {

Vehicle::Vehicle(const VehicleParameters& parameters, const Road& road)
    : parameters_{parameters}, road_{road}, model_{parameters} {
    reset();
}

// The plane on which the wheels stand: square to the lines that join the middles of the axles and of the
// sides.
Vehicle::Ground Vehicle::ground_below(const InitialState& initial) const {
    const double front = parameters_.geometry.front_axle_to_cg_m;
    const double rear = parameters_.geometry.rear_axle_to_cg_m;
    const double half_track = 0.5 * parameters_.geometry.track_width_m;
    const Vector3 ahead{std::cos(initial.yaw_angle_rad), std::sin(initial.yaw_angle_rad), 0.0};
    const Vector3 left = Vector3::UnitZ().cross(ahead);
    const Vector3 below{initial.position_x_m, initial.position_y_m, 0.0};
    const auto contact = [&](double along, double across) {
        Vector3 point = below + along * ahead + across * left;
        point.z() = road_.at(point.x(), point.y()).height_m;
        return point;
    };
    const Vector3 front_left_contact = contact(front, half_track);
    const Vector3 front_right_contact = contact(front, -half_track);
    const Vector3 rear_left_contact = contact(-rear, half_track);
    const Vector3 rear_right_contact = contact(-rear, -half_track);
    const Vector3 front_middle = 0.5 * (front_left_contact + front_right_contact);
    const Vector3 rear_middle = 0.5 * (rear_left_contact + rear_right_contact);
    const Vector3 across = front_left_contact + rear_left_contact - front_right_contact - rear_right_contact;
    return {(rear * front_middle.z() + front * rear_middle.z()) / (front + rear),
            (front_middle - rear_middle).cross(across).normalized()};
}

void Vehicle::reset(const InitialState& initial) {
    const Ground ground = ground_below(initial);
    const Vector3 course{std::cos(initial.yaw_angle_rad), std::sin(initial.yaw_angle_rad), 0.0};
    const Vector3 forward = (course - ground.normal * ground.normal.dot(course)).normalized();
    Matrix3 axes;
    axes << forward, ground.normal.cross(forward), ground.normal;

    model_.state = State{};
    model_.state.position = Vector3{initial.position_x_m, initial.position_y_m, ground.height_m} +
                            ground.normal * (parameters_.geometry.cg_height_m + initial.height_offset_m);
    model_.state.orientation = Eigen::Quaterniond{axes} *
                               Eigen::AngleAxisd{initial.pitch_offset_rad, Vector3::UnitY()} *
                               Eigen::AngleAxisd{initial.roll_offset_rad, Vector3::UnitX()};
    model_.state.velocity = model_.state.orientation.conjugate() * (forward * initial.speed_mps);
    if (initial.sideways_mps != 0.0) {
        model_.state.velocity += model_.state.orientation.conjugate() * (axes.col(1) * initial.sideways_mps);
    }
    model_.state.angular_velocity =
        Vector3{initial.roll_rate_radps, initial.pitch_rate_radps, initial.yaw_rate_radps};
    for (int wheel = 0; wheel < wheel_count; ++wheel) {
        const double deflection =
            is_front(wheel) ? model_.front_tyre_deflection_m : model_.rear_tyre_deflection_m;
        model_.state.wheel_spin_radps[static_cast<std::size_t>(wheel)] =
            initial.speed_mps / (parameters_.geometry.wheel_radius_m - deflection);
    }
    const auto hitch = [this] {
        if (parameters_.trailer.mass_kg > 0.0) {
            const Matrix3 rotation = model_.state.orientation.toRotationMatrix();
            hitch_trailer(parameters_, rotation, Vector3{rotation * model_.state.velocity}, model_.state);
        }
    };
    hitch();
    model_.evaluation = Evaluation{};
    model_.evaluate(DriverInput{}, nominal_step_s, road_);
    model_.state.slip = {};
    model_.state.ploughed_m = {};
    model_.state.front_lateral_n = 0.0;
    model_.state.load_offset_m = 0.0;
    model_.state.load_rate_mps = 0.0;
    hitch();
    truth_ = model_.truth();
}

void Vehicle::step(const DriverInput& input, double step_s) {
    model_.step(input, step_s, road_);
    truth_ = model_.truth();
}

}  // namespace sil
