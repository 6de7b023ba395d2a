// Measure: from body-fixed sensor values to the road-parallel and road-normal specific forces at the sprung
// CG, and the roll angle against the road, with the observer's where the sensor has none.
#pragma once

#include "rsi/measurement/road_bank.hpp"
#include "rsi/measurement/roll_bank_observer.hpp"
#include "rsi/measurement/roll_sensor_check.hpp"
#include "rsi/numeric/filtered_derivative.hpp"
#include "rsi/types.hpp"

namespace rsi {

// Outputs of the observer, NaN if unknown.
struct RollObservation {
    float roll_angle_rad{not_available};
    float bank_angle_rad{not_available};
    bool sensor_disagrees{false};
};

// Measurements of the vehicle in one step. All finite but for the observation.
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

// Estimates of the vehicle from the samples before.
struct Learnt {
    float vertical_movement_m{0.0F};  // dh, 0 where there is no sound estimate
    float roll_factor{1.0F};          // roll angle under the load over the calibrated body's
};

class MeasurementStage {
 public:
    struct Constants {
        Constants() = default;
        [[gnu::cold]] Constants(const Parameters& parameters, const ObserverGains& gains);

        bool against_horizon{false};  // the sensor's angle
        float imu_x_m{};
        float imu_y_m{};
        float imu_z_m{};
        DerivativeLag lag;
        RollBankObserver::Constants observer;
        RollSensorCheck::Constants check;
    };

    void reset();

    // Forgets the road's bank: for another reference of the sensor's angle.
    void reset_bank() { road_bank_.reset(); }

    // True and a measurement when lateral force and roll rate are available and in range, and the roll angle
    // against the road is, or the observer knows it.
    bool update(const Constants& constants, const Inputs& inputs, const Learnt& learnt,
                Measurement& measurement);

 private:
    // Both forces carried from the IMU to the CG; the pitch rate is not measured and left out.
    BodyForces carry_to_cg(const Constants& constants, const Inputs& inputs, bool yaw_known);
    void observe(const Constants& constants, const Inputs& inputs, const Learnt& learnt, bool yaw_known,
                 const BodyForces& at_cg, Measurement& measurement);
    void run_observer(const Constants& constants, const Inputs& inputs, const Learnt& learnt,
                      bool motion_known, const BodyForces& at_cg);

    // The sensor's angle against the road; NaN where it has none, or where what it contains of a bank is not
    // known.
    float sensed_roll_rad(bool against_horizon, const Inputs& inputs);

    FilteredDerivative roll_acceleration_{};
    FilteredDerivative yaw_acceleration_{};
    RollBankObserver observer_{};
    RoadBank road_bank_{};
    RollSensorCheck check_{};
};

}  // namespace rsi
