// Mechanical energy of the vehicle.
#include "sil/world/vehicle/vehicle.hpp"

namespace sil {

double Vehicle::mechanical_energy_j() const {
    const BasicAxlePose<double> axle =
        model_.rear_axle.pose(model_.state.suspension[2], model_.state.suspension[3]);
    const auto& q = model_.state.suspension;
    const auto& rate = model_.state.suspension_rate;
    const Vector3& omega = model_.state.angular_velocity;
    double energy = 0.0;
    const auto add_mass = [&](double mass, const Vector3& position, const Vector3& relative_velocity) {
        const Vector3 velocity = model_.state.velocity + omega.cross(position) + relative_velocity;
        const double height = (model_.state.position + model_.state.orientation * position).z();
        energy += mass * (0.5 * velocity.squaredNorm() + gravity_mps2 * height);
    };

    add_mass(parameters_.mass.sprung_kg, Vector3::Zero(), Vector3::Zero());
    energy += 0.5 * omega.dot(model_.inertia.cwiseProduct(omega));
    for (int wheel = front_left; wheel <= front_right; ++wheel) {
        const auto index = static_cast<std::size_t>(wheel);
        const double outward = wheel == front_left ? 1.0 : -1.0;
        add_mass(parameters_.mass.front_unsprung_kg, model_.front_wheel_position(wheel),
                 Vector3{0.0, outward * model_.front_path.slope(q[index]), 1.0} * rate[index]);
        energy += model_.front_spring.stored_energy_j(q[index]);
    }
    energy += 0.5 * parameters_.front_suspension.anti_roll_bar_npm * (q[0] - q[1]) * (q[0] - q[1]);

    add_mass(parameters_.mass.rear_axle_kg, axle.centre,
             axle.centre_by_heave * rate[2] + axle.centre_by_roll * rate[3]);
    const Vector3 axle_rotation = omega + Vector3{rate[3], 0.0, 0.0};
    const double along = axle_rotation.dot(axle.direction);
    energy += 0.5 * parameters_.inertia.rear_axle_kgm2 * (axle_rotation.squaredNorm() - along * along);
    const double lift = q[2] + axle.pivot_m * (1.0 - axle.direction.y());
    const double twist = model_.state.frame_twist_rad;
    const double tilt = parameters_.rear_suspension.spring_half_base_m * (axle.direction.z() - twist);
    energy +=
        model_.rear_spring.stored_energy_j(lift + tilt) + model_.rear_spring.stored_energy_j(lift - tilt);
    const double bent = q[3] - twist;
    energy += 0.5 * parameters_.rear_suspension.anti_roll_bar_nmprad * bent * bent;
    const RearSuspensionParameters& rear = parameters_.rear_suspension;
    if (rear.frame_twists()) {
        const double turning = model_.state.frame_twist_radps;
        const double part_kg = rear.frame_rear_share * parameters_.mass.sprung_kg;
        add_mass(-part_kg, model_.rear_part_position(0.0), Vector3::Zero());
        add_mass(part_kg, model_.rear_part_position(twist), model_.rear_part_path(twist) * turning);
        energy += rear.frame_rear_share * parameters_.inertia.sprung_roll_kgm2 * turning *
                  (omega.x() + 0.5 * turning);
        energy += 0.5 * rear.frame_torsion_nmprad * twist * twist;
    }

    for (std::size_t i = 0; i < wheel_count; ++i) {
        const auto& spring = is_front(static_cast<int>(i)) ? model_.front_spring : model_.rear_spring;
        energy += spring.friction_energy_j(model_.state.friction_share[i]);
    }

    for (std::size_t i = 0; i < wheel_count; ++i) {
        const double deflection = model_.evaluation.wheels[i].deflection_m;
        energy += deflection > 0.0 ? model_.front_tyre.stored_energy_j(deflection) : 0.0;
        const double spin = model_.state.wheel_spin_radps[i];
        energy += 0.5 * parameters_.inertia.wheel_spin_kgm2 * spin * spin;
    }
    return energy;
}

}  // namespace sil
