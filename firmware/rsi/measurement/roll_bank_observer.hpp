// Roll and bank observer: the body's roll angle and the road's bank from IMU, yaw rate and speed, without a
// roll sensor.
#pragma once

#include <cstdint>

#include "rsi/measurement/observer_gains.hpp"
#include "rsi/model/roll_stiffness_curve.hpp"
#include "rsi/numeric/filtered_derivative.hpp"
#include "rsi/types.hpp"

namespace rsi {

// The settled gains follow from these two.
[[gnu::cold]] UprightRoll upright_roll(const Parameters& parameters);
[[gnu::cold]] ObserverNoise observer_noise(const Parameters& parameters);

// Extended Kalman filter with four states [phi, w, b, o]: roll angle relative to the road, the body's roll
// rate against the horizon, the road's bank, and the part of w that is not phi': the bank's rate, or the
// gyro's bias.
//   phi' = w - o,  w' = [m_s H f_yb / cos phi - M(phi) - c_f phi'] / Ixx,  b' = o,  o decays, all wander.
// Two scalar measurements: the gyro, p = w, and the kinematics of the turn,
// f_yb - r V = g sin(phi + b) + v_y', where the unknown v_y' counts as noise that grows with |r'|, and with
// an innovation that no road explains. The covariance is that of the steady filter (observer_gains), but for
// the variances of phi and of the bank, which are updated in every step: they say what is known, and carry
// the start, a standstill, a slide and the bump stops into the gains. While the inner wheels are up, the
// suspension says nothing and the gyro alone moves phi.
class RollBankObserver {
 public:
    struct Constants {
        Constants() = default;
        // `gains`: the settled ones, for the same parameters.
        [[gnu::cold]] Constants(const Parameters& parameters, const ObserverGains& gains);

        RollStiffnessCurve stiffness_over_inertia;  // M / Ixx
        float force_to_acceleration{};              // m_s H / Ixx
        float movement_to_acceleration{};           // m_s / Ixx
        float damping_over_inertia{};               // c_f / Ixx
        float tipping_force_mps2{};
        ObserverGains gains{};
    };

    // One sample of the signals that the observer takes, all finite.
    struct Signals {
        float lateral_force_mps2;  // f_yb, the specific force at the sprung CG along the body's y axis
        float roll_rate_radps;
        float yaw_rate_radps;
        float speed_mps;
    };

    // Forgets everything; the next update starts anew.
    void reset() { running_ = false; }

    // One sample. `vertical_movement_m` is dh, 0 where there is no sound estimate. Only its first 0.05 m
    // count: dh has been learnt from the roll sensor, and an implausible sensor must not move the observer
    // with it. A state that is not finite starts anew at the next sample.
    void update(const Constants& constants, const Signals& signals, float vertical_movement_m);

    // Whether the angle's standard deviation is small enough to be relied on. False after a start for as long
    // as the filter needs.
    bool roll_known() const {
        return running_ && (P11_ < (tipped() ? largest_tipped_variance_rad2 : largest_roll_variance_rad2));
    }
    // Whether it is small enough to begin with.
    bool roll_roughly_known() const { return running_ && (P11_ < rough_roll_variance_rad2); }
    bool bank_known() const { return running_ && (P33_ < largest_bank_variance_rad2); }

    // The inner wheels are up: the roll angle comes from the gyro alone, to some ten degrees.
    bool tipped() const { return tipped_ > 0U; }

    float roll_angle_rad() const { return state_(State::roll); }  // relative to the road, within +-1.57
    float bank_angle_rad() const { return state_(State::bank); }  // left side up is positive, within +-0.5

 private:
    using State = ObserverState;

    static constexpr float largest_roll_variance_rad2 = 0.0175F * 0.0175F;  // 1 deg
    static constexpr float rough_roll_variance_rad2 = 0.035F * 0.035F;      // 2 deg
    static constexpr float largest_tipped_variance_rad2 = 0.175F * 0.175F;  // 10 deg
    static constexpr float largest_bank_variance_rad2 = 0.07F * 0.07F;      // 4 deg

    [[gnu::cold, gnu::noinline]] void begin_in_balance(const Constants& constants, float lateral_force_mps2,
                                                       float roll_rate_radps);
    void predict(const Constants& constants, float lateral_force_mps2, float vertical_movement_m);
    std::uint32_t tipped_for(const Constants& constants, float lateral_force_mps2,
                             float roll_acceleration_radps2) const;
    void correct_by_roll_rate(const ObserverGains& gains, float roll_rate_radps);
    void correct_by_turn(const ObserverGains& gains, float gravity_part_mps2, float yaw_acceleration_radps2);
    void keep_in_bounds();

    FilteredDerivative yaw_acceleration_{};

    bool running_{false};
    std::uint32_t tipped_{};          // samples for which it may still be
    Vector4 state_{Vector4::Zero()};  // [phi, w, b, o]
    float stiffness_step_{};          // s: what an error of phi makes of the rate in one step
    float P11_{};                     // variance of phi
    float P33_{};                     // variance of the bank
};

}  // namespace rsi
