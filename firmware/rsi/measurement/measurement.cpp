#include "rsi/measurement/measurement.hpp"

#include "rsi/measurement/plausible_motion.hpp"
#include "rsi/numeric/bounded_functions.hpp"

namespace rsi {
namespace {

constexpr float largest_force_mps2 = 60.0F;
constexpr float largest_roll_angle_rad = 2.2F;
constexpr float largest_bank_angle_rad = 0.8F;

// A vehicle that is nearly weightless has no meaningful ratio A/N; the bound keeps the division safe.
constexpr float smallest_normal_force_mps2 = 0.1F * gravity_mps2;

bool within(float value, float limit) {
    return is_within_magnitude(value, limit);
}

bool necessary_inputs_available(const Inputs& inputs) {
    return within(inputs.lateral_specific_force_mps2, largest_force_mps2) &&
           within(inputs.roll_rate_radps, largest_plausible_rate_radps);
}

// Bank of the road; flat if the angle is not available.
struct Bank {
    float sine{0.0F};
    float cosine{1.0F};
    float tangent{0.0F};
};

// The cosine of an available angle is at least 0.69.
Bank bank_of(float bank_angle_rad) {
    Bank bank;
    if (within(bank_angle_rad, largest_bank_angle_rad)) {
        const SineAndVersine of = sine_and_versine(bank_angle_rad);
        bank = Bank{of.sine, 1.0F - of.versine, of.sine / (1.0F - of.versine)};
    }
    return bank;
}

struct RoadForces {
    float parallel;
    float normal;
};

// A = f_y cos phi - f_z sin phi, N = f_y sin phi + f_z cos phi: a rotation, no bank angle needed.
RoadForces rotate_to_road(float lateral, float vertical, float sine, float cosine) {
    return RoadForces{lateral * cosine - vertical * sine, lateral * sine + vertical * cosine};
}

// Without f_z: f_y = A cos phi + N sin phi, with N = g / cos b - A tan b, which holds while the vertical
// acceleration is zero. The divisor is cos(phi + b) / cos b.
RoadForces assume_no_heave(float lateral, float sine, float cosine, const Bank& bank) {
    const float normal_at_rest = gravity_mps2 / bank.cosine;
    const float divisor = larger(cosine - bank.tangent * sine, 0.1F);
    const float parallel = (lateral - normal_at_rest * sine) / divisor;
    return RoadForces{parallel, normal_at_rest - parallel * bank.tangent};
}

// A body under a load rolls further than the observer's, which is the calibrated one.
float beyond_observed_rad(float sensed_rad, float observed_rad, float roll_factor) {
    const float laden_rad = roll_factor * observed_rad;
    return sensed_rad - clamp(sensed_rad, smaller(observed_rad, laden_rad), larger(observed_rad, laden_rad));
}

}  // namespace

MeasurementStage::Constants::Constants(const Parameters& parameters, const ObserverGains& gains)
    : against_horizon(parameters.roll_angle_reference == RSI_ROLL_AGAINST_HORIZON),
      imu_x_m(parameters.imu_x_m),
      imu_y_m(parameters.imu_y_m),
      imu_z_m(parameters.imu_z_m),
      lag(parameters.angular_acceleration_lag_s),
      observer(parameters, gains),
      check(parameters) {}

void MeasurementStage::reset() {
    roll_acceleration_.reset();
    yaw_acceleration_.reset();
    observer_.reset();
    road_bank_.reset();
    check_.reset();
}

// f_cg = f_imu - alpha x r - omega x (omega x r) with pitch rate q = 0:
//   f_y,cg = f_y - (r' x - p' z) + (p^2 + r^2) y
//   f_z,cg = f_z - p' y - p (r x - p z)
BodyForces MeasurementStage::carry_to_cg(const Constants& constants, const Inputs& inputs, bool yaw_known) {
    const float p = inputs.roll_rate_radps;
    const float r = yaw_known ? inputs.yaw_rate_radps : 0.0F;
    const float roll_acceleration = roll_acceleration_.update(constants.lag, p);
    float yaw_acceleration = 0.0F;
    if (yaw_known) {
        yaw_acceleration = yaw_acceleration_.update(constants.lag, r);
    } else {
        yaw_acceleration_.reset();
    }
    BodyForces forces;
    forces.lateral_mps2 = inputs.lateral_specific_force_mps2 -
                          (yaw_acceleration * constants.imu_x_m - roll_acceleration * constants.imu_z_m) +
                          (p * p + r * r) * constants.imu_y_m;
    forces.vertical_mps2 = inputs.vertical_specific_force_mps2 - roll_acceleration * constants.imu_y_m -
                           p * (r * constants.imu_x_m - p * constants.imu_z_m);
    return forces;
}

// The observer separates roll from bank in an angle against the horizon. Force and gyro are enough
// for that, so it goes on without yaw rate and speed, but is no substitute for a sensor then.
void MeasurementStage::run_observer(const Constants& constants, const Inputs& inputs, const Learnt& learnt,
                                    bool motion_known, const BodyForces& at_cg) {
    if (motion_known) {
        observer_.update(
            constants.observer,
            {at_cg.lateral_mps2, inputs.roll_rate_radps, inputs.yaw_rate_radps, inputs.speed_mps},
            learnt.vertical_movement_m);
    } else if (constants.against_horizon) {
        observer_.update(constants.observer, {at_cg.lateral_mps2, inputs.roll_rate_radps, 0.0F, 0.0F},
                         learnt.vertical_movement_m);
    } else {
        observer_.reset();
    }
}

float MeasurementStage::sensed_roll_rad(bool against_horizon, const Inputs& inputs) {
    const float angle_rad = inputs.roll_angle_rad;
    if (!within(angle_rad, largest_roll_angle_rad)) {
        road_bank_.reset();
        return not_available;
    }
    if (!against_horizon) {
        return angle_rad;
    }
    // With the inner wheels up the observer has the roll of the gyro, as the sensor does: the bank stays.
    if (observer_.roll_roughly_known() && !observer_.tipped()) {
        road_bank_.follow(angle_rad, observer_.roll_angle_rad());
    }
    if (within(inputs.bank_angle_rad, largest_bank_angle_rad)) {
        return angle_rad - inputs.bank_angle_rad;
    }
    return road_bank_.known() ? angle_rad - road_bank_.angle_rad() : not_available;
}

// The observer runs whether it is needed or not, so that it knows the angle when the sensor fails.
void MeasurementStage::observe(const Constants& constants, const Inputs& inputs, const Learnt& learnt,
                               bool yaw_known, const BodyForces& at_cg, Measurement& measurement) {
    const bool motion_known = yaw_known && within(inputs.speed_mps, largest_plausible_speed_mps);
    run_observer(constants, inputs, learnt, motion_known, at_cg);
    const float sensed_rad = sensed_roll_rad(constants.against_horizon, inputs);
    const bool sensor_available = is_finite(sensed_rad);
    const bool roll_known = motion_known && observer_.roll_known();
    RollObservation& observed = measurement.observed;
    observed.roll_angle_rad = roll_known ? observer_.roll_angle_rad() : not_available;
    observed.bank_angle_rad = observer_.bank_known() ? observer_.bank_angle_rad() : not_available;
    measurement.roll_angle_is_measured =
        sensor_available &&
        (!constants.against_horizon || within(inputs.bank_angle_rad, largest_bank_angle_rad));
    if (sensor_available) {
        measurement.roll_source = RSI_ROLL_SENSOR;
        measurement.roll_angle_rad = sensed_rad;
    } else {
        measurement.roll_source = roll_known ? RSI_ROLL_OBSERVER : RSI_ROLL_NONE;
        measurement.roll_angle_rad = observed.roll_angle_rad;
    }
    if (!sensor_available || !roll_known) {
        check_.reset();
    } else if (!observer_.tipped()) {
        check_.update(constants.check,
                      beyond_observed_rad(sensed_rad, observed.roll_angle_rad, learnt.roll_factor));
    } else {
        // The observer's model ends where the vehicle tips: the check keeps what it has.
    }
    observed.sensor_disagrees = check_.disagrees();
}

bool MeasurementStage::update(const Constants& constants, const Inputs& inputs, const Learnt& learnt,
                              Measurement& measurement) {
    if (!necessary_inputs_available(inputs)) {
        reset();
        return false;
    }
    const bool yaw_known = within(inputs.yaw_rate_radps, largest_plausible_rate_radps);
    const BodyForces at_cg = carry_to_cg(constants, inputs, yaw_known);
    observe(constants, inputs, learnt, yaw_known, at_cg, measurement);
    if (measurement.roll_source == RSI_ROLL_NONE) {
        roll_acceleration_.reset();
        yaw_acceleration_.reset();
        return false;
    }
    const Bank bank = bank_of(inputs.bank_angle_rad);
    // Past 1.3 rad, where the vehicle lies on its side, the tangent grows no further.
    const SineAndVersine roll = bounded_sine_and_versine(measurement.roll_angle_rad);
    const float cosine = 1.0F - roll.versine;
    const RoadForces forces = within(inputs.vertical_specific_force_mps2, largest_force_mps2)
                                  ? rotate_to_road(at_cg.lateral_mps2, at_cg.vertical_mps2, roll.sine, cosine)
                                  : assume_no_heave(at_cg.lateral_mps2, roll.sine, cosine, bank);

    measurement.road_parallel_force_mps2 = forces.parallel;
    measurement.road_normal_force_mps2 = larger(forces.normal, smallest_normal_force_mps2);
    // The inverse of A = a_y cos b + g sin b, N = g cos b - a_y sin b.
    measurement.lateral_acceleration_mps2 = forces.parallel * bank.cosine - forces.normal * bank.sine;
    measurement.roll_rate_radps = inputs.roll_rate_radps;
    measurement.tan_roll_angle = roll.sine / cosine;
    measurement.versine_roll_angle = roll.versine;
    measurement.tan_bank_angle = bank.tangent;
    return true;
}

}  // namespace rsi
