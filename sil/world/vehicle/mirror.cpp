// Mirror images in the plane y = 0.
#include "sil/world/vehicle/mirror.hpp"

#include <utility>

namespace sil {
namespace {

void exchange_sides(std::array<double, wheel_count>& values) {
    std::swap(values[front_left], values[front_right]);
    std::swap(values[rear_left], values[rear_right]);
}

}  // namespace

Truth mirrored(const Truth& truth) {
    Truth image = truth;
    for (double* value :
         {&image.steering_wheel_angle_rad, &image.road_wheel_angle_rad, &image.position_y_m,
          &image.yaw_angle_rad, &image.lateral_velocity_mps, &image.roll_angle_rad,
          &image.roll_to_horizon_rad, &image.bank_angle_rad, &image.angular_velocity_radps[0],
          &image.angular_velocity_radps[2], &image.angular_acceleration_radps2[0],
          &image.angular_acceleration_radps2[2], &image.specific_force_mps2[1],
          &image.lateral_acceleration_mps2, &image.lateral_tyre_force_n, &image.roll_centre_lateral_m}) {
        *value = -*value;
    }
    exchange_sides(image.wheel_load_n);
    exchange_sides(image.suspension_deflection_m);
    exchange_sides(image.wheel_gap_m);
    exchange_sides(image.wheel_spin_radps);
    return image;
}

Disturbance mirrored(const Disturbance& disturbance) {
    Disturbance image = disturbance;
    image.side_force_n = -image.side_force_n;
    exchange_sides(image.grip);
    exchange_sides(image.lost_air);
    return image;
}

}  // namespace sil
