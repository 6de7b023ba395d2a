// Measure: from body-fixed sensor values to the road-parallel and road-normal specific forces at the sprung
// CG, and the roll angle against the road, with the observer's where the sensor has none.
#pragma once

#include "rsi/measurement/road_bank.hpp"
#include "rsi/measurement/roll_bank_observer.hpp"
#include "rsi/measurement/roll_sensor_check.hpp"
#include "rsi/numeric/filtered_derivative.hpp"
#include "rsi/types.hpp"

namespace rsi {

// What the observer says, NaN where it does not know.
struct RollObservation {
    float roll_angle_rad{not_available};
    float bank_angle_rad{not_available};
    bool sensor_disagrees{false};
};

// What the algorithm knows of the vehicle in one step. All finite but for the observation.
struct Measurement {
    float road_parallel_force_mps2{0.0F};   // A = a_y cos b + g sin b, left
    float road_normal_force_mps2{0.0F};     // N = g cos b - a_y sin b, up; at least 0.1 g
    float lateral_acceleration_mps2{0.0F};  // a_y, horizontal; equals A where the bank is not known
    float roll_angle_rad{0.0F};             // phi_m, relative to the road
    float roll_rate_radps{0.0F};            // phi_m'
    float tan_roll_angle{0.0F};
    float versine_roll_angle{0.0F};  // 1 - cos phi_m
    float tan_bank_angle{0.0F};      // of b, 0 where it is not known
    rsi_roll_source roll_source{RSI_ROLL_NONE};
    // The sensor's, and no bank in it that only the observer knows: then it would be the observer's in the
    // end.
    bool roll_angle_is_measured{false};
    RollObservation observed{};
};

// Specific force in body axes; the vertical one is NaN where it is not available.
struct BodyForces {
    float lateral_mps2{0.0F};
    float vertical_mps2{0.0F};
};

class MeasurementStage {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);

    // As init, but keeps the observer's settled gains.
    [[gnu::cold]] void reinitialise(const Parameters& parameters);

    // The parameters from now on; what is known of the motion stays, and so do the observer's settled gains.
    [[gnu::cold]] void tune(const Parameters& parameters);

    void assume_gains(const ObserverGains& gains) { observer_.assume_gains(gains); }

    void reset();

    // True and a measurement when lateral force and roll rate are available and in range, and the roll angle
    // against the road is, or the observer knows it.
    bool update(const Inputs& inputs, Measurement& measurement);

    // dh for the observer from now on, 0 where no sound estimate is.
    void assume_movement(float vertical_movement_m) { observer_.assume_movement(vertical_movement_m); }

    // The sprung mass over the calibrated one, where the vehicle's mass is known; else 1.
    void assume_mass(float factor) { mass_factor_ = factor; }

 private:
    // Both forces carried from the IMU to the CG; the pitch rate is not measured and left out.
    BodyForces carry_to_cg(const Inputs& inputs, bool yaw_known);
    void observe(const Inputs& inputs, bool yaw_known, const BodyForces& at_cg, Measurement& measurement);
    void run_observer(const Inputs& inputs, bool motion_known, const BodyForces& at_cg);

    // The sensor's angle against the road; NaN where it has none, or where what it contains of a bank is not
    // known.
    float sensed_roll_rad(const Inputs& inputs);

    float beyond_observed_rad(float sensed_rad, float observed_rad) const;

    bool against_horizon_{false};
    float mass_factor_{1.0F};
    float imu_x_m_{0.0F};
    float imu_y_m_{0.0F};
    float imu_z_m_{0.0F};
    FilteredDerivative roll_acceleration_{};
    FilteredDerivative yaw_acceleration_{};
    RollBankObserver observer_{};
    RoadBank road_bank_{};
    RollSensorCheck check_{};
};

}  // namespace rsi
