// Random quantities: for each quantity of a drawn vehicle a random number of its own.
#pragma once

#include <cstdint>

#include "sil/random.hpp"
#include "sil/studies/population/vehicle_class.hpp"

namespace sil {

// The numbers are part of the reproducible result: never change one, only add.
enum class Quantity : std::uint64_t {
    size = 1,
    mass = 2,
    wheelbase = 3,
    track = 4,
    static_stability_factor = 5,
    front_load = 6,
    unsprung = 7,
    wheel_radius = 8,
    roll_gyration = 9,
    pitch_gyration = 10,
    yaw_gyration = 11,
    rigid_front = 12,
    rigid_rear = 13,
    front_roll_centre = 14,
    rear_roll_centre = 15,
    front_frequency = 16,
    rear_frequency = 17,
    spring_base = 18,
    roll_gradient = 19,
    front_stiffness_share = 20,
    bump_damping = 21,
    rebound_damping = 22,
    early_front_stop = 23,
    early_rear_stop = 24,
    front_jounce_clearance = 25,
    front_rebound_clearance = 26,
    rear_jounce_clearance = 27,
    rear_rebound_clearance = 28,
    front_stop = 29,
    rear_stop = 30,
    tyre_deflection = 31,
    cornering = 32,
    cornering_peak = 33,
    relaxation = 34,
    camber_thrust = 35,
    grip = 36,
    friction_loss = 37,
    front_friction = 38,
    rear_friction = 39,
    shape = 40,
    curvature = 41,
    slip_stiffness = 42,
    rolling_resistance = 43,
    steering_ratio = 44,
    steering_lag = 45,
    imu_height = 46,
    imu_forward = 47,
    imu_left = 48,
    body_height = 49,
    length = 50,
    drag_area = 51,
    front_drive = 52,
    path_change = 53,
    camber_gain = 54,
    damper_base = 55,
    panhard_length = 56,
    steering_compliance = 57,
    ramp_end = 58,
    lateral_deflection = 59,
    progression = 60,
    leaf_springs = 61,
    dry_friction = 62,
    twisting_frame = 63,
    frame_torsion = 64,
    frame_damping = 65,
    frame_rear_share = 66,
};

class RandomQuantities {
 public:
    RandomQuantities(std::uint64_t seed, std::uint64_t vehicle, unsigned attempt)
        : key_{scrambled(scrambled(scrambled(seed) ^ vehicle) ^ attempt)} {}

    double unit(Quantity quantity) const {
        return unit_interval(scrambled(key_ ^ scrambled(static_cast<std::uint64_t>(quantity))));
    }
    double within(Quantity quantity, const Interval& interval) const {
        return interval.lowest + unit(quantity) * (interval.highest - interval.lowest);
    }
    // A dimension that large vehicles of the class have more of.
    double sized(Quantity quantity, const Interval& interval) const {
        const double part = size_part * unit(Quantity::size) + (1.0 - size_part) * unit(quantity);
        return interval.lowest + part * (interval.highest - interval.lowest);
    }
    bool happens(Quantity quantity, const Interval& share) const { return unit(quantity) < share.lowest; }

 private:
    // How much of a dimension goes with the vehicle's size; the rest is its own.
    static constexpr double size_part = 0.7;

    std::uint64_t key_;
};

}  // namespace sil
