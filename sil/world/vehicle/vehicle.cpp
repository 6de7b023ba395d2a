// Vehicle: assembly of all forces into the equations of motion, and integration.
#include "sil/world/vehicle/vehicle.hpp"

#include <algorithm>
#include <cmath>

#include "sil/world/vehicle/driveline.hpp"
#include "sil/world/vehicle/hull.hpp"
#include "sil/world/vehicle/truth_builder.hpp"
#include "sil/world/vehicle/wheel_contact.hpp"

namespace sil {
namespace {

constexpr double hull_may_touch_below = 0.7;  // cosine of the angle between body z and road normal
constexpr double smallest_heading = 1e-6;

// Sprung weight on each front or rear wheel in static equilibrium.
double front_spring_load_n(const VehicleParameters& p) {
    return 0.5 * p.mass.sprung_kg * gravity_mps2 * p.geometry.rear_axle_to_cg_m / wheelbase_m(p.geometry);
}
double rear_spring_load_n(const VehicleParameters& p) {
    return 0.5 * p.mass.sprung_kg * gravity_mps2 * p.geometry.front_axle_to_cg_m / wheelbase_m(p.geometry);
}

constexpr bool is_front(int wheel) {
    return wheel == front_left || wheel == front_right;
}
constexpr double side(int wheel) {
    return wheel == front_left || wheel == rear_left ? 1.0 : -1.0;
}

}  // namespace

// A wheel carried by the vehicle; body axes.
struct Vehicle::WheelPose {
    Vector3 centre;
    Vector3 axis;               // of spin, to the left
    Vector3 relative_velocity;  // of the centre in the body
    double relative_roll_rate;  // of the carrier in the body
    double outward_slope;       // front only: of the wheel's path
    const AxlePose* axle;       // rear only
};

Vehicle::Vehicle(const VehicleParameters& parameters, const Road& road)
    : parameters_{parameters},
      road_{road},
      inertia_{parameters.inertia.sprung_roll_kgm2, parameters.inertia.sprung_pitch_kgm2,
               parameters.inertia.sprung_yaw_kgm2},
      front_tyre_deflection_m_{
          (front_spring_load_n(parameters) + parameters.mass.front_unsprung_kg * gravity_mps2) /
          parameters.tyre.vertical_stiffness_npm},
      rear_tyre_deflection_m_{
          (rear_spring_load_n(parameters) + 0.5 * parameters.mass.rear_axle_kg * gravity_mps2) /
          parameters.tyre.vertical_stiffness_npm},
      front_spring_{parameters.front_suspension.spring_damper, front_spring_load_n(parameters)},
      rear_spring_{parameters.rear_suspension.spring_damper, rear_spring_load_n(parameters)},
      front_path_{parameters.front_suspension},
      rear_axle_{parameters.rear_suspension,
                 Vector3{-parameters.geometry.rear_axle_to_cg_m, 0.0,
                         parameters.geometry.wheel_radius_m - rear_tyre_deflection_m_ -
                             parameters.geometry.cg_height_m}},
      front_tyre_{parameters.tyre, parameters.tyre.front_friction_factor},
      rear_tyre_{parameters.tyre, parameters.tyre.rear_friction_factor} {
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

    state_ = State{};
    state_.position = Vector3{initial.position_x_m, initial.position_y_m, ground.height_m} +
                      ground.normal * (parameters_.geometry.cg_height_m + initial.height_offset_m);
    state_.orientation = Eigen::Quaterniond{axes} *
                         Eigen::AngleAxisd{initial.pitch_offset_rad, Vector3::UnitY()} *
                         Eigen::AngleAxisd{initial.roll_offset_rad, Vector3::UnitX()};
    state_.velocity = state_.orientation.conjugate() * (forward * initial.speed_mps);
    state_.angular_velocity =
        Vector3{initial.roll_rate_radps, initial.pitch_rate_radps, initial.yaw_rate_radps};
    for (int wheel = 0; wheel < wheel_count; ++wheel) {
        const double deflection = is_front(wheel) ? front_tyre_deflection_m_ : rear_tyre_deflection_m_;
        state_.wheel_spin_radps[static_cast<std::size_t>(wheel)] =
            initial.speed_mps / (parameters_.geometry.wheel_radius_m - deflection);
    }
    evaluation_ = Evaluation{};
    evaluate(DriverInput{}, nominal_step_s);
    state_.slip = {};
    state_.front_lateral_n = 0.0;
    truth_ = build_truth(parameters_, front_path_, state_, evaluation_);
}

void Vehicle::step(const DriverInput& input, double step_s) {
    integrate(step_s);
    evaluate(input, step_s);
    truth_ = build_truth(parameters_, front_path_, state_, evaluation_);
}

void Vehicle::integrate(double step_s) {
    const Accelerations& acceleration = evaluation_.accelerations;
    state_.time_s += step_s;
    // In the earth-fixed frame, where turning the axes cannot add to the speed.
    const Vector3 body_acceleration = acceleration.linear + state_.angular_velocity.cross(state_.velocity);
    const Vector3 earth_velocity = evaluation_.rotation * (state_.velocity + step_s * body_acceleration);
    state_.angular_velocity += step_s * acceleration.angular;
    for (std::size_t i = 0; i < 4; ++i) {
        state_.suspension_rate[i] += step_s * acceleration.suspension[i];
        state_.suspension[i] += step_s * state_.suspension_rate[i];
        state_.wheel_spin_radps[i] += step_s * evaluation_.wheels[i].spin_acceleration_radps2;
    }
    // Half the rotation vector; the series is exact to the fifth order in a step's angle.
    const Vector3 half = 0.5 * step_s * state_.angular_velocity;
    const double square = half.squaredNorm();
    const Vector3 vector = (1.0 - square / 6.0) * half;
    const Eigen::Quaterniond turn{1.0 - 0.5 * square, vector.x(), vector.y(), vector.z()};
    state_.orientation = (state_.orientation * turn).normalized();
    state_.velocity = state_.orientation.conjugate() * earth_velocity;
    state_.position += step_s * earth_velocity;
}

Vector3 Vehicle::front_wheel_position(int wheel) const {
    const double jounce = state_.suspension[static_cast<std::size_t>(wheel)];
    return {parameters_.geometry.front_axle_to_cg_m,
            side(wheel) * (0.5 * parameters_.geometry.track_width_m + front_path_.outward_m(jounce)),
            parameters_.geometry.wheel_radius_m - front_tyre_deflection_m_ -
                parameters_.geometry.cg_height_m + jounce};
}

void Vehicle::evaluate(const DriverInput& input, double step_s) {
    evaluation_.rotation = state_.orientation.toRotationMatrix();
    evaluation_.steering_wheel_angle_rad = input.steering_wheel_angle_rad;
    state_.reached_handwheel_rad = reached_handwheel_rad(parameters_.steering, state_.reached_handwheel_rad,
                                                         input.steering_wheel_angle_rad, step_s);
    evaluation_.road_wheel =
        road_wheel_angle(parameters_.steering, state_.reached_handwheel_rad, state_.front_lateral_n);
    state_.front_lateral_n = 0.0;  // the wheels add to it
    evaluation_.tyre_force_body_n.setZero();
    const Matrix3& rotation = evaluation_.rotation;
    const Vector3& normal = evaluation_.road_normal =
        road_.mean_normal(state_.position.x(), state_.position.y());
    const Vector3 body_x = rotation.col(0);
    const Vector3 in_plane = body_x - normal * normal.dot(body_x);
    const double length = in_plane.norm();
    if (length > smallest_heading) {  // else the body stands on its nose: keep the last heading
        evaluation_.heading = in_plane / length;
    }

    const Vector3 free_acceleration =
        -gravity_mps2 * rotation.row(2).transpose() - state_.angular_velocity.cross(state_.velocity);
    EquationsOfMotion equations{parameters_.mass.sprung_kg, inertia_, state_.angular_velocity,
                                free_acceleration};

    const auto drive =
        drive_torques_nm(parameters_.driveline, input.drive_force_n, parameters_.geometry.wheel_radius_m,
                         state_.velocity.x(), state_.wheel_spin_radps);
    const double brake = std::clamp(input.brake, 0.0, 1.0);

    for (int wheel = front_left; wheel <= front_right; ++wheel) {
        const auto index = static_cast<std::size_t>(wheel);
        const double jounce = state_.suspension[index];
        const double rate = state_.suspension_rate[index];
        const double slope = front_path_.slope(jounce);
        const Vector3 path{0.0, side(wheel) * slope, 1.0};
        const Vector3 curvature{0.0, side(wheel) * front_path_.slope_rate_pm(jounce), 0.0};
        const double lean = side(wheel) * parameters_.front_suspension.camber_gain_radpm * jounce;
        const RoadWheelAngle& steer = evaluation_.road_wheel;
        const Vector3 axis = Vector3{-steer.sine, steer.cosine, lean} * (1.0 / std::sqrt(1.0 + lean * lean));
        const WheelPose pose{front_wheel_position(wheel), axis, path * rate, 0.0, slope, nullptr};
        equations.add_front_wheel(wheel, parameters_.mass.front_unsprung_kg, pose.centre, path, curvature,
                                  rate);
        wheel_forces(wheel, pose, drive[index], brake * parameters_.driveline.front_brake_nm, step_s,
                     equations);
    }

    const AxlePose axle = rear_axle_.pose(state_.suspension[2], state_.suspension[3]);
    const double heave_rate = state_.suspension_rate[2];
    const double roll_rate = state_.suspension_rate[3];
    equations.add_rear_axle(parameters_.mass.rear_axle_kg, parameters_.inertia.rear_axle_kgm2, axle,
                            heave_rate, roll_rate);
    for (int wheel = rear_left; wheel <= rear_right; ++wheel) {
        const double offset = side(wheel) * 0.5 * parameters_.geometry.track_width_m;
        const WheelPose pose{
            axle.centre + offset * axle.direction,
            axle.direction,
            axle.centre_by_heave * heave_rate + (axle.centre_by_roll + offset * axle.upright) * roll_rate,
            roll_rate,
            0.0,
            &axle};
        wheel_forces(wheel, pose, drive[static_cast<std::size_t>(wheel)],
                     brake * parameters_.driveline.rear_brake_nm, step_s, equations);
    }

    evaluation_.suspension_roll_moment_nm = suspension_forces(axle, equations);

    const double drag = -0.5 * air_density_kgpm3 * parameters_.aerodynamics.drag_area_m2 *
                        state_.velocity.x() * std::abs(state_.velocity.x());
    equations.add_force(Vector3{drag, 0.0, 0.0}, Vector3::Zero());

    if (rotation.col(2).dot(normal) < hull_may_touch_below) {
        add_hull_contact(parameters_.hull, state_, rotation, road_, equations);
    }
    evaluation_.accelerations = equations.solve();
}

void Vehicle::wheel_forces(int wheel, const WheelPose& pose, double drive_torque_nm, double brake_torque_nm,
                           double step_s, EquationsOfMotion& equations) {
    const auto index = static_cast<std::size_t>(wheel);
    WheelEvaluation& result = evaluation_.wheels[index];
    const Tyre& tyre = is_front(wheel) ? front_tyre_ : rear_tyre_;
    const double spin = state_.wheel_spin_radps[index];

    const Vector3 earth_centre = state_.position + evaluation_.rotation * pose.centre;
    const RoadPoint surface = road_.at(earth_centre.x(), earth_centre.y());
    const Vector3 normal = evaluation_.rotation.transpose() * surface.normal;
    const double clearance = (earth_centre.z() - surface.height_m) * surface.normal.z();
    const WheelContact contact =
        find_wheel_contact(pose.axis, normal, clearance, parameters_.geometry.wheel_radius_m);

    const Vector3 point = pose.centre + contact.arm;
    const Vector3 carrier_rotation = state_.angular_velocity + Vector3{pose.relative_roll_rate, 0.0, 0.0};
    const Vector3 velocity = state_.velocity + state_.angular_velocity.cross(pose.centre) +
                             pose.relative_velocity + carrier_rotation.cross(contact.arm);
    const double forward_speed = velocity.dot(contact.forward);
    const double loaded_radius = contact.arm.norm();

    result.deflection_m = contact.deflection_m;
    result.load_n =
        contact.upright ? tyre.vertical_force_n(contact.deflection_m, -velocity.dot(normal)) : 0.0;
    tyre.advance(state_.slip[index], forward_speed, spin * loaded_radius - forward_speed,
                 velocity.dot(contact.left), step_s);
    const TyreForces in_plane =
        tyre.forces(state_.slip[index], result.load_n, surface.friction_factor, contact.camber);
    const Vector3 force = result.load_n * normal + in_plane.longitudinal_n * contact.forward +
                          in_plane.lateral_n * contact.left;

    equations.add_force(force, point);
    if (pose.axle == nullptr) {
        state_.front_lateral_n += in_plane.lateral_n;
        equations.add_suspension_force(wheel, force.z() + side(wheel) * pose.outward_slope * force.y());
    } else {
        const Vector3 from_axle = point - pose.axle->centre;
        equations.add_suspension_force(2, pose.axle->centre_by_heave.dot(force));
        equations.add_suspension_force(
            3, pose.axle->centre_by_roll.dot(force) + from_axle.y() * force.z() - from_axle.z() * force.y());
    }

    // The rotor takes the moment about its axis; the carrier feels what the rotor's momentum takes up.
    const double inertia = parameters_.inertia.wheel_spin_kgm2;
    const double free_torque = contact.arm.cross(force).dot(pose.axis) + drive_torque_nm;
    const double friction =
        friction_torque_nm(brake_torque_nm + tyre.rolling_resistance_n(result.load_n) * loaded_radius, spin,
                           free_torque, inertia, step_s);
    result.spin_acceleration_radps2 = (free_torque + friction) / inertia;
    equations.add_moment(-inertia * (result.spin_acceleration_radps2 * pose.axis +
                                     spin * state_.angular_velocity.cross(pose.axis)));
    evaluation_.tyre_force_body_n += force;
}

double Vehicle::suspension_forces(const AxlePose& axle, EquationsOfMotion& equations) const {
    const auto& q = state_.suspension;
    const auto& rate = state_.suspension_rate;
    const double bar = parameters_.front_suspension.anti_roll_bar_npm * (q[0] - q[1]);
    const double left = front_spring_.elastic_force_n(q[0]) + front_spring_.damper_force_n(rate[0]) + bar;
    const double right = front_spring_.elastic_force_n(q[1]) + front_spring_.damper_force_n(rate[1]) - bar;
    equations.add_suspension_force(0, -left);
    equations.add_suspension_force(1, -right);
    double roll_moment = 0.5 * parameters_.geometry.track_width_m * (right - left);

    const RearSuspensionParameters& rear = parameters_.rear_suspension;
    const double sine = axle.direction.z();
    const double cosine = axle.direction.y();
    const double lift = q[2] + axle.pivot_m * (1.0 - cosine);  // of the axle's centre
    const double lift_by_roll = axle.pivot_m * sine;
    for (const double at : {1.0, -1.0}) {
        const double spring_at = at * rear.spring_half_base_m;
        const double damper_at = at * rear.damper_half_base_m;
        const double spring = rear_spring_.elastic_force_n(lift + spring_at * sine);
        const double damper =
            rear_spring_.damper_force_n(rate[2] + (lift_by_roll + damper_at * cosine) * rate[3]);
        equations.add_suspension_force(2, -(spring + damper));
        equations.add_suspension_force(3, -(spring * (lift_by_roll + spring_at * cosine) +
                                            damper * (lift_by_roll + damper_at * cosine)));
        roll_moment -= spring * spring_at + damper * damper_at;
    }
    const double rear_bar = rear.anti_roll_bar_nmprad * q[3];
    equations.add_suspension_force(3, -rear_bar);
    return roll_moment - rear_bar;
}

}  // namespace sil
