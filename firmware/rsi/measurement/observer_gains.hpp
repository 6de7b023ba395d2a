// Gains of the roll and bank observer: the steady Kalman filter of its four states, computed once.
#pragma once

#include <cstdint>

#include "rsi/numeric/matrix.hpp"
#include "rsi/types.hpp"

namespace rsi {

// The vehicle near the upright, over one step: what the roll angle's and the roll rate's error take from the
// rate (step k, step c of RollBankObserver).
struct UprightRoll {
    float stiffness_step{0.0F};
    float damping_step{0.0F};
};

// Places in the observer's state and its covariance.
struct ObserverState {
    static constexpr Eigen::Index roll = 0;    // phi, relative to the road
    static constexpr Eigen::Index rate = 1;    // w, against the horizon
    static constexpr Eigen::Index bank = 2;    // b
    static constexpr Eigen::Index offset = 3;  // o, what of w is not phi'
};

// Values of the steady filter for each step. The variances of roll and bank are updated in every step,
// because the start, a standstill, a slide and a stiffer spring change them; all other covariances are those
// of the steady filter on a level road above 5 m/s.
struct ObserverGains {
    // Gyro. The gain of phi is (roll_rate_covariance - s P11) / (rate_variance + s^2 P11), with s = step k,
    // and stands in `gyro` only where P11 has settled.
    Vector4 gyro{Vector4::Zero()};
    float roll_rate_covariance{0.0F};
    float rate_variance{1.0F};
    float roll_growth_rad2{0.0F};  // of P11 in one step

    // Turn: covariances of the state with g (phi + b); to the bank's belongs g P33, which is not in it.
    Vector4 turn{Vector4::Zero()};
    float bank_growth_rad2{0.0F};  // of P33 in one step
};

// Variances of the noise in one step, and of the measurements.
struct ObserverNoise {
    float roll_rad2;
    float rate_rad2ps2;
    float bank_rad2;
    float offset_rad2ps2;
    float offset_decay;
    float gyro_rad2ps2;
    float turn_mps2_2;
};

// The same, a few iterations at a time.
class ObserverGainsSearch {
 public:
    [[gnu::cold]] void begin(const UprightRoll& roll, const ObserverNoise& noise);

    // At most so many iterations; true when the gains have settled.
    [[gnu::cold]] bool iterate(std::uint32_t at_most);

    const ObserverGains& gains() const { return gains_; }

 private:
    UprightRoll roll_{};
    ObserverNoise noise_{};
    std::uint32_t left_{0U};
    Matrix4 covariance_{Matrix4::Zero()};
    ObserverGains gains_{};
};

// Iterates the filter's covariance from its start for a bounded number of steps (20 s of driving straight).
[[gnu::cold]] ObserverGains steady_observer_gains(const UprightRoll& roll, const ObserverNoise& noise);

}  // namespace rsi
