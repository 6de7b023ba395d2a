// Roll motion through the lags that the further indicators share: forces, roll state and their derivatives at
// one and the same delay.
#pragma once

#include "rsi/measurement/measurement.hpp"
#include "rsi/numeric/two_lags.hpp"
#include "rsi/types.hpp"

namespace rsi {

// Further than a body rolls on its springs.
inline constexpr float largest_spring_angle_rad = 0.5F;

// tan x to within 1 % up to that angle.
constexpr float short_tangent(float angle_rad) {
    return angle_rad * (1.0F + angle_rad * angle_rad * (1.0F / 3.0F));
}

// All finite.
struct RollMotion {
    float road_parallel_force_mps2{0.0F};       // A
    float road_normal_force_mps2{1.0F};         // N, at least 0.1 g as the measured one is
    float lateral_acceleration_mps2{0.0F};      // a_y
    float roll_angle_rad{0.0F};                 // phi, within largest_spring_angle_rad
    float roll_rate_radps{0.0F};                // phi'
    float roll_acceleration_radps2{0.0F};       // phi'', through one more lag
    float road_parallel_force_rate_mps3{0.0F};  // A', through one more lag
};

class RollMotionFilter {
 public:
    struct Constants {
        Constants() = default;
        [[gnu::cold]] explicit Constants(const Parameters& parameters)
            : weight(lag_weight(parameters.prediction_filter_lag_s)) {}

        float weight{};  // of a new value in each lag
    };

    // The signals start where they are; the derivatives at zero.
    void reset(const Measurement& measured);

    RollMotion update(const Constants& constants, const Measurement& measured);

 private:
    TwoLags parallel_force_{};
    TwoLags normal_force_{};
    TwoLags roll_angle_{};
    TwoLags roll_rate_{};
    float parallel_force_rate_mps3_{};
    float roll_acceleration_radps2_{};
};

}  // namespace rsi
