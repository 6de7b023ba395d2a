#include "rsi/observer/roll_bank_observer.hpp"

namespace rsi {
namespace {

constexpr float square(float value) {
    return value * value;
}

constexpr float radians(float degrees) {
    return degrees * 0.017453293F;
}

constexpr float T = sample_time_s;

// Beyond these the suspension's curve, or the sensor, means nothing.
constexpr float largest_roll_rad = 0.5F;
constexpr float largest_rate_radps = 10.0F;
constexpr float largest_bank_rad = 0.5F;
constexpr float largest_bias_radps = radians(5.0F);

// Below this speed a wheel-speed signal is poor and has no sign, so the turn says nothing about the bank.
constexpr float smallest_speed_mps = 5.0F;
constexpr float yaw_acceleration_lag_s = 0.1F;

// What the model and the measurements are worth, tuned on simulated drives; variances of one step.
constexpr float roll_noise_rad2 = 4.0e-5F * T;
constexpr float rate_noise_rad2ps2 = 2.25F * T;
constexpr float bias_noise_rad2ps2 = square(radians(0.02F)) * T;
constexpr float gyro_variance_rad2ps2 = square(radians(0.4F)) + square(0.02F);
constexpr float turn_variance_factor = 30.0F;  // v_y' is no white noise: it lasts for many samples
constexpr float turn_deviation_mps2 = 0.4F;
#ifndef PI_
#define PI_ 1.0F
#endif
constexpr float plausible_innovation_mps2 = PI_;
constexpr float turn_deviation_per_yaw_acceleration_m = 4.0F;

// Standard deviations at the start.
constexpr float initial_roll_rad = 0.05F;
constexpr float initial_bank_rad = 0.1F;
constexpr float initial_bias_radps = radians(0.5F);

// Any value is replaced when it is smaller than rounding could make of zero, or larger than the bounds above.
float variance_within(float variance, float largest) {
    return clamp(variance, 1.0e-9F, largest);
}

}  // namespace

void RollBankObserver::init(const Parameters& parameters) {
    const float H = parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m;
    stiffness_.init(parameters);
    inverse_inertia_ = 1.0F / parameters.roll_inertia_kgm2;
    force_to_acceleration_ = parameters.sprung_mass_kg * H * inverse_inertia_;
    damping_over_inertia_ = parameters.roll_damping_nmsprad * inverse_inertia_;
    bank_drift_variance_rad2_ = square(parameters.observer_bank_drift_radps) * T;
    yaw_acceleration_.init(yaw_acceleration_lag_s);
    reset();
}

void RollBankObserver::update(float lateral_force_mps2, float roll_rate_radps, float yaw_rate_radps,
                              float speed_mps) {
    if (!running_) {
        start(lateral_force_mps2, roll_rate_radps);
    } else {
        predict(lateral_force_mps2);
    }
    const float yaw_acceleration_radps2 = yaw_acceleration_.update(yaw_rate_radps);
    correct_by_roll_rate(roll_rate_radps);
    if (speed_mps > smallest_speed_mps) {
        correct_by_turn(lateral_force_mps2 - yaw_rate_radps * speed_mps, yaw_acceleration_radps2);
    }
    keep_in_bounds();
}

// In balance on a level road.
void RollBankObserver::start(float lateral_force_mps2, float roll_rate_radps) {
    const float linear_angle_rad =
        force_to_acceleration_ * lateral_force_mps2 / (stiffness_.slope_nmprad(0.0F) * inverse_inertia_);
    phi_ = clamp(linear_angle_rad, -0.2F, 0.2F);
    rate_ = roll_rate_radps;
    bank_ = 0.0F;
    bias_ = 0.0F;
    P11_ = square(initial_roll_rad);
    P22_ = gyro_variance_rad2ps2;
    P33_ = square(initial_bank_rad);
    P44_ = square(initial_bias_radps);
    P12_ = P13_ = P14_ = P23_ = P24_ = P34_ = 0.0F;
    yaw_acceleration_.reset();
    running_ = true;
}

// Trapezoidal rule with the local stiffness k, stable for any admitted parameters:
//   phi+ = phi + T phi' + T/2 d,  phi'+ = phi' + d,  d = T (phi'' - T/2 k phi') / (1 + T/2 c + T^2/4 k)
void RollBankObserver::predict(float lateral_force_mps2) {
    const float secant = 1.0F / bounded_cosine(phi_);
    const float force_secant = force_to_acceleration_ * lateral_force_mps2 * secant;
    const float acceleration =
        force_secant - stiffness_.moment_nm(phi_) * inverse_inertia_ - damping_over_inertia_ * rate_;
    const float k = larger(
        stiffness_.slope_nmprad(phi_) * inverse_inertia_ - force_secant * secant * bounded_sine(phi_), 0.0F);
    const float c = damping_over_inertia_;
    const float step = T / (1.0F + 0.5F * T * (c + 0.5F * T * k));

    const float d = step * (acceleration - 0.5F * T * k * rate_);
    phi_ += T * (rate_ + 0.5F * d);
    rate_ += d;

    // P = F P F^T + Q; F is the identity but for the first two rows and columns.
    const float F21 = -step * k;
    const float F22 = 1.0F - step * (c + 0.5F * T * k);
    const float F11 = 1.0F + 0.5F * T * F21;
    const float F12 = 0.5F * T * (1.0F + F22);
    const float a11 = F11 * P11_ + F12 * P12_;
    const float a12 = F11 * P12_ + F12 * P22_;
    const float a21 = F21 * P11_ + F22 * P12_;
    const float a22 = F21 * P12_ + F22 * P22_;
    P11_ = a11 * F11 + a12 * F12 + roll_noise_rad2;
    P12_ = a11 * F21 + a12 * F22;
    P22_ = a21 * F21 + a22 * F22 + rate_noise_rad2ps2;
    const float p13 = P13_;
    const float p14 = P14_;
    P13_ = F11 * p13 + F12 * P23_;
    P23_ = F21 * p13 + F22 * P23_;
    P14_ = F11 * p14 + F12 * P24_;
    P24_ = F21 * p14 + F22 * P24_;
    P33_ += bank_drift_variance_rad2_;
    P44_ += bias_noise_rad2ps2;
}

// p = phi' + bias
void RollBankObserver::correct_by_roll_rate(float roll_rate_radps) {
    const float c2 = P22_ + P24_;
    const float c4 = P24_ + P44_;
    correct(roll_rate_radps - rate_ - bias_, c2 + c4 + gyro_variance_rad2ps2, P12_ + P14_, c2, P23_ + P34_,
            c4);
}

// f_yb - r V = g sin(phi + b) + v_y'
void RollBankObserver::correct_by_turn(float gravity_part_mps2, float yaw_acceleration_radps2) {
    const float angle = phi_ + bank_;
    const float h = gravity_mps2 * bounded_cosine(angle);
    const float deviation =
        turn_deviation_mps2 + turn_deviation_per_yaw_acceleration_m * absolute(yaw_acceleration_radps2);
    const float c1 = h * (P11_ + P13_);
    const float c3 = h * (P13_ + P33_);
    const float innovation = gravity_part_mps2 - gravity_mps2 * bounded_sine(angle);
    const float surprise = innovation * (1.0F / plausible_innovation_mps2);
    const float variance = turn_variance_factor * deviation * deviation * (1.0F + surprise * surprise*surprise*surprise);
    correct(innovation, h * (c1 + c3) + variance, c1, h * (P12_ + P23_), c3, h * (P14_ + P34_));
}

// A scalar measurement; c = P h, the covariance of state and innovation.
void RollBankObserver::correct(float innovation, float innovation_variance, float c1, float c2, float c3,
                               float c4) {
    const float weight = 1.0F / innovation_variance;
    const float k1 = c1 * weight;
    const float k2 = c2 * weight;
    const float k3 = c3 * weight;
    const float k4 = c4 * weight;
    phi_ += k1 * innovation;
    rate_ += k2 * innovation;
    bank_ += k3 * innovation;
    bias_ += k4 * innovation;
    P11_ -= k1 * c1;
    P12_ -= k1 * c2;
    P13_ -= k1 * c3;
    P14_ -= k1 * c4;
    P22_ -= k2 * c2;
    P23_ -= k2 * c3;
    P24_ -= k2 * c4;
    P33_ -= k3 * c3;
    P34_ -= k3 * c4;
    P44_ -= k4 * c4;
}

void RollBankObserver::keep_in_bounds() {
    // A sum is not finite when a summand is not.
    const float sum =
        phi_ + rate_ + bank_ + bias_ + P11_ + P12_ + P13_ + P14_ + P22_ + P23_ + P24_ + P33_ + P34_ + P44_;
    if (!is_finite(sum)) {
        reset();
        return;
    }
    phi_ = clamp(phi_, -largest_roll_rad, largest_roll_rad);
    rate_ = clamp(rate_, -largest_rate_radps, largest_rate_radps);
    bank_ = clamp(bank_, -largest_bank_rad, largest_bank_rad);
    bias_ = clamp(bias_, -largest_bias_radps, largest_bias_radps);
    P11_ = variance_within(P11_, 1.0F);
    P22_ = variance_within(P22_, 100.0F);
    P33_ = variance_within(P33_, square(initial_bank_rad));
    P44_ = variance_within(P44_, square(initial_bias_radps));
}

}  // namespace rsi
