// Vehicle model: body, suspensions, tyres and wheels put together, and one step of time. Nothing but numbers,
// of one vehicle or, with Lanes for `Real`, of several at once.
#pragma once

#include "sil/world/vehicle/axle.hpp"
#include "sil/world/vehicle/driveline.hpp"
#include "sil/world/vehicle/driver_input.hpp"
#include "sil/world/vehicle/evaluation.hpp"
#include "sil/world/vehicle/hull.hpp"
#include "sil/world/vehicle/moving_load.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/roadside.hpp"
#include "sil/world/vehicle/state.hpp"
#include "sil/world/vehicle/steering.hpp"
#include "sil/world/vehicle/suspension.hpp"
#include "sil/world/vehicle/trailer.hpp"
#include "sil/world/vehicle/truth_builder.hpp"
#include "sil/world/vehicle/tyre.hpp"
#include "sil/world/vehicle/wheel_contact.hpp"

namespace sil {

constexpr bool is_front(int wheel) {
    return wheel == front_left || wheel == front_right;
}
// Side of the vehicle that a wheel is on: left is positive.
constexpr double side_of(int wheel) {
    return wheel == front_left || wheel == rear_left ? 1.0 : -1.0;
}

template <typename Real>
struct VehicleModel {
    using Vector = Vector3Of<Real>;

    explicit VehicleModel(const BasicVehicleParameters<Real>& of)
        : parameters{of},
          inertia{of.inertia.sprung_roll_kgm2, of.inertia.sprung_pitch_kgm2, of.inertia.sprung_yaw_kgm2},
          front_tyre_deflection_m{(front_spring_load_n() + of.mass.front_unsprung_kg * gravity_mps2) /
                                  of.tyre.vertical_stiffness_npm},
          rear_tyre_deflection_m{(rear_spring_load_n() + 0.5 * of.mass.rear_axle_kg * gravity_mps2) /
                                 of.tyre.vertical_stiffness_npm},
          front_spring{of.front_suspension.spring_damper, front_spring_load_n()},
          rear_spring{of.rear_suspension.spring_damper, rear_spring_load_n()},
          front_path{of.front_suspension},
          rear_axle{of.rear_suspension,
                    Vector{-of.geometry.rear_axle_to_cg_m, 0.0,
                           of.geometry.wheel_radius_m - rear_tyre_deflection_m - of.geometry.cg_height_m}},
          frame_arm_m{of.geometry.cg_height_m - of.geometry.wheel_radius_m + rear_tyre_deflection_m -
                      of.rear_suspension.panhard_pivot_m},
          front_tyre{of.tyre, of.tyre.front_friction_factor},
          rear_tyre{of.tyre, of.tyre.rear_friction_factor} {}

    // Integration by the accelerations of the latest evaluation, then the next evaluation.
    template <typename Ground>
    void step(const BasicDriverInput<Real>& input, double step_s, const Ground& road) {
        integrate(step_s);
        evaluate(input, step_s, road);
    }

    template <typename Ground>
    void evaluate(const BasicDriverInput<Real>& input, double step_s, const Ground& road);

    BasicTruth<Real> truth() const {
        return TruthBuilder<Real>::build(parameters, front_path, state, evaluation);
    }

    BasicTruth<Real> motion() const { return TruthBuilder<Real>::motion(parameters, state, evaluation); }

    Vector front_wheel_position(int wheel) const {
        const Real jounce = state.suspension[static_cast<std::size_t>(wheel)];
        return {parameters.geometry.front_axle_to_cg_m,
                side_of(wheel) * (0.5 * parameters.geometry.track_width_m + front_path.outward_m(jounce)),
                parameters.geometry.wheel_radius_m - front_tyre_deflection_m -
                    parameters.geometry.cg_height_m + jounce};
    }

    // The rear part of the body, behind a frame that twists, turns about a line through the axle's roll
    // centre, so that the axle, which holds it there, does no work in it. Its mass is half-way to the axle,
    // at the height of the CG. Its place is exact to the second order in the twist; its path is the
    // derivative.
    Vector rear_part_position(Real twist_rad) const {
        return {-0.5 * parameters.geometry.rear_axle_to_cg_m, -frame_arm_m * twist_rad,
                -0.5 * frame_arm_m * twist_rad * twist_rad};
    }
    Vector rear_part_path(Real twist_rad) const { return {0.0, -frame_arm_m, -frame_arm_m * twist_rad}; }

    BasicVehicleParameters<Real> parameters;
    Vector inertia;
    Real front_tyre_deflection_m;  // in static equilibrium
    Real rear_tyre_deflection_m;
    BasicSpringDamper<Real> front_spring;
    BasicSpringDamper<Real> rear_spring;
    BasicFrontWheelPath<Real> front_path;
    BasicRearAxle<Real> rear_axle;
    Real frame_arm_m;  // of the rear part's mass over the line about which it turns
    BasicTyre<Real> front_tyre;
    BasicTyre<Real> rear_tyre;

    BasicState<Real> state{};
    BasicEvaluation<Real> evaluation{};

 private:
    static constexpr double hull_may_touch_below = 0.7;  // cosine of the angle between body z and road normal
    static constexpr double smallest_heading = 1e-6;

    // A wheel carried by the vehicle; body axes.
    struct WheelPose {
        Vector centre;
        Vector axis;                      // of spin, to the left
        Vector relative_velocity;         // of the centre in the body
        Real relative_roll_rate;          // of the carrier in the body
        Real outward_slope;               // front only: of the wheel's path
        const BasicAxlePose<Real>* axle;  // rear only
    };

    // Sprung weight on each front or rear wheel in static equilibrium.
    Real front_spring_load_n() const {
        return 0.5 * parameters.mass.sprung_kg * gravity_mps2 * parameters.geometry.rear_axle_to_cg_m /
               wheelbase_m(parameters.geometry);
    }
    Real rear_spring_load_n() const {
        return 0.5 * parameters.mass.sprung_kg * gravity_mps2 * parameters.geometry.front_axle_to_cg_m /
               wheelbase_m(parameters.geometry);
    }

    void integrate(double step_s);
    Real suspension_forces(const BasicAxlePose<Real>& axle, double step_s,
                           EquationsOfMotion<Real>& equations);
    void twist_frame(Real rear_moment_nm, EquationsOfMotion<Real>& equations) const;
    template <typename Ground>
    void wheel_forces(int wheel, const WheelPose& pose, Real drive_torque_nm, Real brake_torque_nm,
                      const BasicDisturbance<Real>& disturbance, double step_s, const Ground& road,
                      EquationsOfMotion<Real>& equations);
    void side_wind(const BasicDisturbance<Real>& disturbance, EquationsOfMotion<Real>& equations) const;
    void kerb_force(int wheel, const WheelPose& pose, const BasicWheelContact<Real>& contact,
                    const BasicRoadPoint<Real>& surface, EquationsOfMotion<Real>& equations) const;
    // Part of a force on a wheel that moves the suspension coordinates of that wheel.
    template <typename Condition>
    void add_suspension_forces_if(Condition condition, int wheel, const WheelPose& pose, const Vector& force,
                                  const Vector& point, EquationsOfMotion<Real>& equations) const;
};

template <typename Real>
void VehicleModel<Real>::integrate(double step_s) {
    const BasicAccelerations<Real>& acceleration = evaluation.accelerations;
    state.time_s += step_s;
    // In the earth-fixed frame, where turning the axes cannot add to the speed.
    const Vector body_acceleration = acceleration.linear + state.angular_velocity.cross(state.velocity);
    const Vector body_velocity = state.velocity + step_s * body_acceleration;
    const Vector earth_velocity = product(evaluation.rotation, body_velocity);
    state.angular_velocity += step_s * acceleration.angular;
    for (std::size_t i = 0; i < 4; ++i) {
        state.suspension_rate[i] += step_s * acceleration.suspension[i];
        state.suspension[i] += step_s * state.suspension_rate[i];
        state.wheel_spin_radps[i] += step_s * evaluation.wheels[i].spin_acceleration_radps2;
    }
    state.frame_twist_radps += step_s * acceleration.frame_twist;
    state.frame_twist_rad += step_s * state.frame_twist_radps;
    // Half the rotation vector; the series is exact to the fifth order in a step's angle.
    const Vector half = 0.5 * step_s * state.angular_velocity;
    const Real square = dot3(half, half);
    const Vector vector = (1.0 - square / 6.0) * half;
    const QuaternionOf<Real> turn{1.0 - 0.5 * square, vector.x(), vector.y(), vector.z()};
    state.orientation = normalised(product(state.orientation, turn));
    state.velocity = state.orientation.conjugate() * earth_velocity;
    state.position += step_s * earth_velocity;
}

template <typename Real>
template <typename Ground>
void VehicleModel<Real>::evaluate(const BasicDriverInput<Real>& input, double step_s, const Ground& road) {
    evaluation.rotation = state.orientation.toRotationMatrix();
    evaluation.steering_wheel_angle_rad = input.steering_wheel_angle_rad;
    state.reached_handwheel_rad = reached_handwheel_rad(parameters.steering, state.reached_handwheel_rad,
                                                        input.steering_wheel_angle_rad, step_s);
    evaluation.road_wheel =
        road_wheel_angle(parameters.steering, state.reached_handwheel_rad, state.front_lateral_n);
    state.front_lateral_n = 0.0;  // the wheels add to it
    evaluation.tyre_force_body_n = Vector{0.0, 0.0, 0.0};
    const Matrix3Of<Real>& rotation = evaluation.rotation;
    const Vector& normal = evaluation.road_normal = road.mean_normal(state.position.x(), state.position.y());
    const Vector body_x = rotation.col(0);
    const Vector in_plane = body_x - normal * dot3(normal, body_x);
    const Real length = norm3(in_plane);
    for (int i = 0; i < 3; ++i) {
        // Else the body stands on its nose: keep the last heading.
        evaluation.heading[i] =
            number::choose(length > smallest_heading, in_plane[i] / length, evaluation.heading[i]);
    }

    const Vector free_acceleration =
        -gravity_mps2 * rotation.row(2).transpose() - state.angular_velocity.cross(state.velocity);
    EquationsOfMotion<Real> equations{parameters.mass.sprung_kg, inertia, state.angular_velocity,
                                      free_acceleration};

    const auto drive =
        drive_torques_nm(parameters.driveline, input.drive_force_n, parameters.geometry.wheel_radius_m,
                         state.velocity.x(), state.wheel_spin_radps);
    const Real brake = number::clamp(input.brake, 0.0, 1.0);

    for (int wheel = front_left; wheel <= front_right; ++wheel) {
        const auto index = static_cast<std::size_t>(wheel);
        const double side = side_of(wheel);
        const Real jounce = state.suspension[index];
        const Real rate = state.suspension_rate[index];
        const Real slope = front_path.slope(jounce);
        const Vector path{0.0, side * slope, 1.0};
        const Vector curvature{0.0, side * front_path.slope_rate_pm(jounce), 0.0};
        const Real lean = side * parameters.front_suspension.camber_gain_radpm * jounce;
        const BasicRoadWheelAngle<Real>& steer = evaluation.road_wheel;
        const Real shorter = 1.0 / number::sqrt(1.0 + lean * lean);
        const Vector axis = Vector{-steer.sine, steer.cosine, lean} * shorter;
        const WheelPose pose{front_wheel_position(wheel), axis, path * rate, 0.0, slope, nullptr};
        equations.add_front_wheel(wheel, parameters.mass.front_unsprung_kg, pose.centre, path, curvature,
                                  rate);
        wheel_forces(wheel, pose, drive[index], brake * parameters.driveline.front_brake_nm,
                     input.disturbance, step_s, road, equations);
    }

    const BasicAxlePose<Real> axle = rear_axle.pose(state.suspension[2], state.suspension[3]);
    const Real heave_rate = state.suspension_rate[2];
    const Real roll_rate = state.suspension_rate[3];
    equations.add_rear_axle(parameters.mass.rear_axle_kg, parameters.inertia.rear_axle_kgm2, axle, heave_rate,
                            roll_rate);
    for (int wheel = rear_left; wheel <= rear_right; ++wheel) {
        const Real offset = side_of(wheel) * 0.5 * parameters.geometry.track_width_m;
        const WheelPose pose{
            axle.centre + offset * axle.direction,
            axle.direction,
            axle.centre_by_heave * heave_rate + (axle.centre_by_roll + offset * axle.upright) * roll_rate,
            roll_rate,
            0.0,
            &axle};
        wheel_forces(wheel, pose, drive[static_cast<std::size_t>(wheel)],
                     brake * parameters.driveline.rear_brake_nm, input.disturbance, step_s, road, equations);
    }

    evaluation.suspension_roll_moment_nm = suspension_forces(axle, step_s, equations);

    const Real drag = -0.5 * air_density_kgpm3 * parameters.aerodynamics.drag_area_m2 * state.velocity.x() *
                      number::abs(state.velocity.x());
    equations.add_force(Vector{drag, 0.0, 0.0}, Vector{0.0, 0.0, 0.0});
    side_wind(input.disturbance, equations);
    move_load(parameters.moving_load, evaluation, step_s, state, equations);
    pull_trailer(parameters, evaluation, step_s, state, equations);

    const auto tipped = dot3(rotation.col(2), normal) < hull_may_touch_below;
    if (number::any(tipped)) {
        add_hull_contact(tipped, parameters.hull, state, rotation, road, equations);
    }
    evaluation.accelerations = equations.solve();
}

template <typename Real>
template <typename Ground>
void VehicleModel<Real>::wheel_forces(int wheel, const WheelPose& pose, Real drive_torque_nm,
                                      Real brake_torque_nm, const BasicDisturbance<Real>& disturbance,
                                      double step_s, const Ground& road, EquationsOfMotion<Real>& equations) {
    const auto index = static_cast<std::size_t>(wheel);
    const Real flat = disturbance.lost_air[index];
    BasicWheelEvaluation<Real>& result = evaluation.wheels[index];
    const BasicTyre<Real>& tyre = is_front(wheel) ? front_tyre : rear_tyre;
    const Real spin = state.wheel_spin_radps[index];

    const Vector earth_centre = state.position + product(evaluation.rotation, pose.centre);
    const BasicRoadPoint<Real> surface = road.at(earth_centre.x(), earth_centre.y());
    const Vector normal = transposed_product(evaluation.rotation, surface.normal);
    const Real clearance = (earth_centre.z() - surface.height_m) * surface.normal.z();
    const BasicWheelContact<Real> contact =
        find_wheel_contact(pose.axis, normal, clearance,
                           parameters.geometry.wheel_radius_m * (1.0 - FlatTyre::lost_radius * flat));

    const Vector carrier_rotation = state.angular_velocity + Vector{pose.relative_roll_rate, 0.0, 0.0};
    const Vector velocity = state.velocity + state.angular_velocity.cross(pose.centre) +
                            pose.relative_velocity + carrier_rotation.cross(contact.arm);
    const Real forward_speed = dot3(velocity, contact.forward);
    const Real loaded_radius = norm3(contact.arm);

    result.deflection_m = contact.deflection_m;
    result.load_n = number::choose(contact.upright(),
                                   tyre.vertical_force_n(contact.deflection_m, -dot3(velocity, normal)), 0.0);
    tyre.advance(state.slip[index], forward_speed, spin * loaded_radius - forward_speed,
                 dot3(velocity, contact.left), step_s);
    const BasicTyreForces<Real> in_plane = tyre.forces(
        state.slip[index], result.load_n,
        surface.friction_factor * disturbance.grip[index] * (1.0 - FlatTyre::lost_friction * flat),
        contact.camber, 1.0 - FlatTyre::lost_stiffness * flat);
    Vector force = result.load_n * normal + in_plane.longitudinal_n * contact.forward +
                   in_plane.lateral_n * contact.left;
    const auto soft = surface.softness > 0.0;
    if (number::any(soft)) {
        const Real pile_n = soft_ground_force_n(surface.softness, result.load_n, dot3(velocity, contact.left),
                                                forward_speed, step_s, soft, state.ploughed_m[index]);
        for (int i = 0; i < 3; ++i) {
            force[i] = number::choose(soft, force[i] + pile_n * contact.left[i], force[i]);
        }
    }

    const Vector point =
        pose.centre + contact.arm + tyre.lateral_deflection_m(in_plane.lateral_n) * contact.left;
    equations.add_force(force, point);
    if (pose.axle == nullptr) {
        state.front_lateral_n += in_plane.lateral_n;
        equations.add_suspension_force(wheel, force.z() + side_of(wheel) * pose.outward_slope * force.y());
    } else {
        const Vector from_axle = point - pose.axle->centre;
        equations.add_suspension_force(2, dot3(pose.axle->centre_by_heave, force));
        equations.add_suspension_force(3, dot3(pose.axle->centre_by_roll, force) + from_axle.y() * force.z() -
                                              from_axle.z() * force.y());
    }

    // The rotor takes the moment about its axis; the carrier feels what the rotor's momentum takes up.
    const Real inertia_kgm2 = parameters.inertia.wheel_spin_kgm2;
    const Vector moment = contact.arm.cross(force);
    const Real free_torque = dot3(moment, pose.axis) + drive_torque_nm;
    const Real friction =
        friction_torque_nm(brake_torque_nm + tyre.rolling_resistance_n(result.load_n) *
                                                 (1.0 + FlatTyre::added_resistance * flat) * loaded_radius,
                           spin, free_torque, inertia_kgm2, step_s);
    result.spin_acceleration_radps2 = (free_torque + friction) / inertia_kgm2;
    equations.add_moment(-inertia_kgm2 * (result.spin_acceleration_radps2 * pose.axis +
                                          spin * state.angular_velocity.cross(pose.axis)));
    evaluation.tyre_force_body_n += force;

    if (number::any(number::abs(surface.beyond_kerb_m) > 0.0)) {
        kerb_force(wheel, pose, contact, surface, equations);
    }
}

template <typename Real>
void VehicleModel<Real>::side_wind(const BasicDisturbance<Real>& disturbance,
                                   EquationsOfMotion<Real>& equations) const {
    const auto blows = number::abs(disturbance.side_force_n) > 0.0;
    if (number::any(blows)) {
        equations.add_force_if(blows, Vector{0.0, disturbance.side_force_n, 0.0},
                               Vector{disturbance.side_force_ahead_m, 0.0, disturbance.side_force_above_m});
    }
}

// Square to the face, half the kerb's height above the road.
template <typename Real>
void VehicleModel<Real>::kerb_force(int wheel, const WheelPose& pose, const BasicWheelContact<Real>& contact,
                                    const BasicRoadPoint<Real>& surface,
                                    EquationsOfMotion<Real>& equations) const {
    const Vector body_velocity =
        state.velocity + state.angular_velocity.cross(pose.centre) + pose.relative_velocity;
    const Real across_mps = dot3(evaluation.rotation.row(1), body_velocity);
    const Real force_n =
        kerb_force_n(surface, contact.deflection_m, across_mps, parameters.tyre.vertical_stiffness_npm);
    const auto touches = number::abs(force_n) > 0.0;
    const Vector force = force_n * evaluation.rotation.row(1).transpose();
    const Vector up = evaluation.rotation.row(2).transpose();
    const Vector point = pose.centre + contact.arm + 0.5 * surface.kerb_height_m * up;
    equations.add_force_if(touches, force, point);
    add_suspension_forces_if(touches, wheel, pose, force, point, equations);
}

template <typename Real>
template <typename Condition>
void VehicleModel<Real>::add_suspension_forces_if(Condition condition, int wheel, const WheelPose& pose,
                                                  const Vector& force, const Vector& point,
                                                  EquationsOfMotion<Real>& equations) const {
    if (pose.axle == nullptr) {
        equations.add_suspension_force_if(condition, wheel,
                                          force.z() + side_of(wheel) * pose.outward_slope * force.y());
        return;
    }
    const Vector from_axle = point - pose.axle->centre;
    equations.add_suspension_force_if(condition, 2, dot3(pose.axle->centre_by_heave, force));
    equations.add_suspension_force_if(
        condition, 3,
        dot3(pose.axle->centre_by_roll, force) + from_axle.y() * force.z() - from_axle.z() * force.y());
}

template <typename Real>
Real VehicleModel<Real>::suspension_forces(const BasicAxlePose<Real>& axle, double step_s,
                                           EquationsOfMotion<Real>& equations) {
    const auto& q = state.suspension;
    const auto& rate = state.suspension_rate;
    const auto add_friction = [&](const BasicSpringDamper<Real>& spring, int wheel, const Real& rate_mps,
                                  Real& force_n) {
        const auto rubs = spring.has_friction();
        if (number::any(rubs)) {
            Real& share = state.friction_share[static_cast<std::size_t>(wheel)];
            share = number::choose(rubs, spring.rubbed_share(share, step_s * rate_mps), share);
            force_n = number::choose(rubs, force_n + spring.friction_force_n(share), force_n);
        }
    };
    const Real bar = parameters.front_suspension.anti_roll_bar_npm * (q[0] - q[1]);
    Real left = front_spring.elastic_force_n(q[0]) + front_spring.damper_force_n(rate[0]) + bar;
    Real right = front_spring.elastic_force_n(q[1]) + front_spring.damper_force_n(rate[1]) - bar;
    add_friction(front_spring, front_left, rate[0], left);
    add_friction(front_spring, front_right, rate[1], right);
    equations.add_suspension_force(0, -left);
    equations.add_suspension_force(1, -right);
    Real roll_moment = 0.5 * parameters.geometry.track_width_m * (right - left);

    const BasicRearSuspensionParameters<Real>& rear = parameters.rear_suspension;
    const Real& twist = state.frame_twist_rad;
    const Real& twist_rate = state.frame_twist_radps;
    const Real sine = axle.direction.z();
    const Real cosine = axle.direction.y();
    const Real lift = q[2] + axle.pivot_m * (1.0 - cosine);  // of the axle's centre
    const Real lift_by_roll = axle.pivot_m * sine;
    const Real rear_bar = rear.anti_roll_bar_nmprad * (q[3] - twist);
    Real rear_moment = rear_bar;
    for (const int wheel : {rear_left, rear_right}) {
        const double at = side_of(wheel);
        const Real spring_at = at * rear.spring_half_base_m;
        const Real damper_at = at * rear.damper_half_base_m;
        Real spring = rear_spring.elastic_force_n(lift + spring_at * (sine - twist));
        const Real damper = rear_spring.damper_force_n(
            rate[2] + (lift_by_roll + damper_at * cosine) * rate[3] - damper_at * twist_rate);
        add_friction(rear_spring, wheel,
                     rate[2] + (lift_by_roll + spring_at * cosine) * rate[3] - spring_at * twist_rate,
                     spring);
        equations.add_suspension_force(2, -(spring + damper));
        equations.add_suspension_force(3, -(spring * (lift_by_roll + spring_at * cosine) +
                                            damper * (lift_by_roll + damper_at * cosine)));
        roll_moment -= spring * spring_at + damper * damper_at;
        rear_moment += spring * spring_at + damper * damper_at;
    }
    equations.add_suspension_force(3, -rear_bar);
    twist_frame(rear_moment, equations);
    return roll_moment - rear_bar;
}

// `rear_moment_nm`: of the rear suspension.
template <typename Real>
void VehicleModel<Real>::twist_frame(Real rear_moment_nm, EquationsOfMotion<Real>& equations) const {
    const BasicRearSuspensionParameters<Real>& rear = parameters.rear_suspension;
    const Real& share = rear.frame_rear_share;
    const auto twists = rear.frame_twists();
    if (!number::any(twists)) {
        return;
    }
    const Real& twist = state.frame_twist_rad;
    const Real moment = rear_moment_nm - rear.frame_torsion_nmprad * twist -
                        rear.frame_damping_nmsprad * state.frame_twist_radps;
    equations.add_turning_part_if(twists, share * parameters.mass.sprung_kg,
                                  share * parameters.inertia.sprung_roll_kgm2, rear_part_position(0.0),
                                  rear_part_position(twist), rear_part_path(twist),
                                  Vector{0.0, 0.0, -frame_arm_m}, state.frame_twist_radps, moment);
}

}  // namespace sil
