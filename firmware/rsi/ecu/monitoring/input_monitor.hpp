// Input monitor: which of the sensors' values may be used.
#pragma once

#include "rsi/ecu/monitoring/diagnostic_memory.hpp"
#include "rsi/ecu/monitoring/flight.hpp"
#include "rsi/ecu/monitoring/force_gain.hpp"
#include "rsi/ecu/monitoring/force_vote.hpp"
#include "rsi/ecu/monitoring/lateral_offset.hpp"
#include "rsi/ecu/monitoring/mass_check.hpp"
#include "rsi/ecu/monitoring/roll_consistency.hpp"
#include "rsi/ecu/monitoring/roll_reference_check.hpp"
#include "rsi/ecu/monitoring/sensor_noise.hpp"
#include "rsi/ecu/monitoring/signal_check.hpp"
#include "rsi/ecu/monitoring/signatures.hpp"
#include "rsi/ecu/monitoring/slow_vehicle.hpp"
#include "rsi/ecu/monitoring/starting_angle.hpp"
#include "rsi/ecu/monitoring/steering_check.hpp"
#include "rsi/ecu/monitoring/stuck_check.hpp"
#include "rsi/ecu/monitoring/travel_direction.hpp"
#include "rsi/ecu/monitoring/turn_consistency.hpp"
#include "rsi/ecu/monitoring/turn_signs.hpp"
#include "rsi/ecu/monitoring/vertical_offset.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// Which frames have fresh values.
struct FreshFrames {
    bool imu{false};
    bool roll_angle{false};
    bool vehicle_motion{false};
    bool vertical_acceleration{true};  // the IMU has sent one before; of one that has none nothing is missed
    // Roll angle that is not fresh because its frames are held back; else NaN.
    float late_roll_angle_rad{rsi::not_available};
};

class InputMonitor {
 public:
    // Starts anew, for a vehicle with these accepted parameters.
    void start(const rsi::Parameters& parameters) noexcept;

    // One cycle. `inputs` as received, NaN where there is nothing; `before` is what the component made of the
    // cycle before. The answer has NaN in place of what must not be used.
    rsi::Inputs qualify(const rsi::Inputs& inputs, const FreshFrames& fresh, const rsi::Outputs& before,
                        DiagnosticMemory& memory) noexcept;

    // Offset of the lateral accelerometer, as minutes of driving have shown it; start() keeps it.
    const LateralOffset& lateral_offset() const noexcept { return lateral_offset_; }
    // That of the trip before. False, with nothing restored, for a value out of range.
    [[gnu::cold]] bool restore_offset(float learnt_mps2) noexcept {
        return lateral_offset_.restore(learnt_mps2);
    }

 private:
    rsi::Inputs check_each(const rsi::Inputs& inputs, const FreshFrames& fresh,
                           DiagnosticMemory& memory) noexcept;
    void check_stuck(const rsi::Inputs& inputs, DiagnosticMemory& memory) noexcept;
    Symptoms roll_symptoms(const rsi::Inputs& inputs, float late_roll_angle_rad) noexcept;
    Symptoms isolation_symptoms(const rsi::Inputs& inputs) const noexcept;
    Symptoms turn_symptoms(const rsi::Inputs& inputs, const rsi::Outputs& before, CodeSet confirmed) noexcept;
    void learn_offset(float beyond_yaw_mps2, const rsi::Outputs& before, CodeSet confirmed) noexcept;
    Symptoms gain_symptoms(const rsi::Outputs& before) noexcept;
    Symptoms vertical_symptoms(const rsi::Inputs& inputs, const rsi::Outputs& before) noexcept;
    Symptoms reference_symptoms(const rsi::Inputs& inputs, const rsi::Outputs& before) noexcept;
    Symptoms observer_symptoms(const rsi::Inputs& inputs, const rsi::Outputs& before) const noexcept;
    static void judge(Symptoms seen, DiagnosticMemory& memory) noexcept;
    void invalidate(rsi::Inputs& qualified, CodeSet confirmed) const noexcept;
    float roll_against_road(const rsi::Inputs& inputs) const noexcept;
    float roll_beyond_observed(const rsi::Inputs& inputs, const rsi::Outputs& before) const noexcept;

    bool against_horizon_{false};  // the roll sensor's angle, as calibrated
    bool steering_fitted_{true};

    // Ranges: beyond what a vehicle does, and below the end of the sensor's range, so that a saturated sensor
    // counts as failed. Jumps: half as much again as the largest change within a cycle over 2,900 drawn runs
    // of three vehicles, impacts of wheels that come down again among them, is still allowed.
    // Steps: a hump throws the vertical acceleration up; only one that is too small warns.
    static constexpr float no_limit = 1.0e6F;
    SignalCheck lateral_{{-40.0F, 40.0F, 12.0F, 3.0F, DiagnosticCode::lateral_acceleration_invalid,
                          DiagnosticCode::lateral_acceleration_jump, 5.0F, 5.0F}};
    SignalCheck vertical_{{-40.0F, 55.0F, 12.0F, 2.2F, DiagnosticCode::vertical_acceleration_invalid,
                           DiagnosticCode::vertical_acceleration_jump, no_limit, 5.0F}};
    SignalCheck roll_rate_{
        {-5.22F, 5.22F, 0.5F, 0.1F, DiagnosticCode::roll_rate_invalid, DiagnosticCode::roll_rate_jump}};
    // Jump: against the change that the roll rate leads to.
    SignalCheck roll_angle_{
        {-1.9F, 1.9F, 0.044F, 0.04F, DiagnosticCode::roll_angle_invalid, DiagnosticCode::roll_angle_jump}};
    SignalCheck yaw_rate_{
        {-4.0F, 4.0F, 0.2F, 0.1F, DiagnosticCode::yaw_rate_invalid, DiagnosticCode::yaw_rate_jump}};
    SignalCheck speed_{{0.0F, 97.0F, 1.5F, 0.5F, DiagnosticCode::speed_invalid, DiagnosticCode::speed_jump}};
    SignalCheck steering_{
        {-15.0F, 15.0F, 2.0F, 0.3F, DiagnosticCode::steering_invalid, DiagnosticCode::steering_jump}};

    // Spans of the reference: at least one and a half times what ideal sensors, which do repeat themselves,
    // came to.
    StuckCheck lateral_stuck_{1.0F};   // m/s^2 of yaw rate times speed
    StuckCheck vertical_stuck_{1.5F};  // m/s^2 of the lateral one
    // rad of the roll angle less the integrated roll rate, and of that; a gyro's offset up to 0.55 deg/s is
    // none
    StuckCheck roll_rate_stuck_{0.02F, 0.0001F};
    StuckCheck roll_angle_stuck_{0.015F, 0.0001F};
    StuckCheck yaw_rate_stuck_{1.5F};  // m/s^2 of the lateral acceleration
    // The same less gravity's share as the roll rate tilts the body: a bank or a ferry's deck turns no
    // vehicle. Drift: gravity times that of a gyro.
    StuckCheck yaw_rate_untilted_{1.5F, 0.001F};
    StuckCheck speed_stuck_{4.5F};  // m/s^2 of yaw rate times this very speed
    SteeringCheck steering_stuck_{};

    RollConsistency roll_consistency_{};
    RollReferenceCheck roll_reference_{};
    StartingAngle starting_angle_{};
    TravelDirection direction_{};
    TurnConsistency turn_consistency_{};
    TurnSigns turn_signs_{};
    ForceVote force_vote_{};
    ForceGain force_gain_{};
    SlowVehicle slow_vehicle_{};
    VerticalOffset vertical_offset_{};
    Flight flight_{};
    SensorNoise speed_noise_{};
    MassCheck mass_{};
    LateralOffset lateral_offset_{};
    float turned_rad_{0.0F};  // integral of the roll rate, as a reference
    // The faulty one of roll rate and roll angle, as long as they contradict each other.
    OfRoll wrong_of_roll_{otherwise_wrong};
};

}  // namespace rsi::monitoring
