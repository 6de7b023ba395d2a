#include "rsi/observer/roll_bank_observer.hpp"
#include "rsi/numeric/square.hpp"

namespace rsi {
namespace {

constexpr float radians(float degrees) {
    return degrees * 0.017453293F;
}

constexpr float T = sample_time_s;

// Beyond these the suspension's curve, or the sensor, means nothing.
constexpr float largest_movement_m = 0.05F;
constexpr float largest_roll_rad = 1.57F;
constexpr float largest_rate_radps = 10.0F;
constexpr float largest_bank_rad = 0.5F;
constexpr float largest_offset_radps = radians(5.0F);

// Below this speed a wheel-speed signal is poor and has no sign, so the turn says nothing about the bank.
constexpr float smallest_speed_mps = 5.0F;
constexpr float yaw_acceleration_lag_s = 0.1F;

// What the model and the measurements are worth, tuned on simulated drives; variances of one step.
constexpr float roll_noise_rad2 = 9.0e-5F * T;
constexpr float rate_noise_rad2ps2 = 0.36F * T;
constexpr float offset_noise_rad2ps2 = square(radians(2.0F)) * T;
constexpr float offset_decay = 1.0F - T / 0.6F;
constexpr float gyro_variance_rad2ps2 = square(radians(0.45F));
// v_y' is no white noise: it lasts for many samples, so it counts as more than it is.
constexpr float turn_deviation_mps2 = 6.0F;
constexpr float turn_deviation_per_yaw_acceleration_m = 7.0F;
// A larger one comes from a vehicle that slides, not from a road that has suddenly tilted.
constexpr float plausible_innovation_mps2 = 2.0F;

// Standard deviations at the start, and largest ones.
constexpr float initial_roll_rad = 0.05F;
constexpr float initial_bank_rad = 0.1F;
constexpr float initial_offset_radps = radians(1.0F);

// Any value is replaced when it is smaller than rounding could make of zero, or larger than the bounds above.
float within_model(float angle_rad) {
    return clamp_magnitude(angle_rad, 0.5F);
}

float variance_within(float variance, float largest) {
    return clamp(variance, 1.0e-9F, largest);
}

}  // namespace

void RollBankObserver::init(const Parameters& parameters) {
    const float H = parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m;
    stiffness_.init(parameters);
    inverse_inertia_ = 1.0F / parameters.roll_inertia_kgm2;
    movement_to_acceleration_ = parameters.sprung_mass_kg * inverse_inertia_;
    force_to_acceleration_ = movement_to_acceleration_ * H;
    damping_over_inertia_ = parameters.roll_damping_nmsprad * inverse_inertia_;
    bank_drift_variance_rad2_ = square(parameters.observer_bank_drift_radps) * T;
    tipping_force_mps2_ = 0.5F * gravity_mps2 * parameters.track_width_m / parameters.sprung_cg_height_m;
    yaw_acceleration_.init(yaw_acceleration_lag_s);
    reset();
}

void RollBankObserver::update(float lateral_force_mps2, float roll_rate_radps, float yaw_rate_radps,
                              float speed_mps, float vertical_movement_m) {
    if (!running_) {
        start(lateral_force_mps2, roll_rate_radps);
    } else {
        predict(lateral_force_mps2, vertical_movement_m);
    }
    const float yaw_acceleration_radps2 = yaw_acceleration_.update(yaw_rate_radps);
    correct_by_roll_rate(roll_rate_radps);
    if ((speed_mps > smallest_speed_mps) && !tipped_) {
        correct_by_turn(lateral_force_mps2 - yaw_rate_radps * speed_mps, yaw_acceleration_radps2);
    }
    keep_in_bounds();
}

// In balance on a level road.
void RollBankObserver::start(float lateral_force_mps2, float roll_rate_radps) {
    const float linear_angle_rad =
        force_to_acceleration_ * lateral_force_mps2 / (stiffness_.slope_nmprad(0.0F) * inverse_inertia_);
    phi_ = clamp_magnitude(linear_angle_rad, 0.2F);
    rate_ = roll_rate_radps;
    bank_ = 0.0F;
    offset_ = 0.0F;
    P11_ = square(initial_roll_rad);
    P22_ = gyro_variance_rad2ps2;
    P33_ = square(initial_bank_rad);
    P44_ = square(initial_offset_radps);
    P12_ = P13_ = P14_ = P23_ = P24_ = P34_ = 0.0F;
    yaw_acceleration_.reset();
    tipped_ = false;
    running_ = true;
}

// The inner wheels have lifted, so the suspension no longer holds the body: from the force that tips the
// standing vehicle until the body has come back to where the suspension would hold it.
bool RollBankObserver::tips(float lateral_force_mps2, float roll_acceleration_radps2) const {
    const bool beyond_suspension = (phi_ * roll_acceleration_radps2 < 0.0F);
    const bool begins =
        (absolute(lateral_force_mps2) > tipping_force_mps2_) && (P11_ < largest_roll_variance_rad2);
    return begins || (tipped_ && beyond_suspension);
}

// Trapezoidal rule with the local stiffness k, stable for any admitted parameters:
//   phi+ = phi + T (w - o) + T/2 d,  w+ = w + d,  b+ = b + T o,  o+ = decay o,
//   d = T [m_s H f_yb / cos phi - M - (c + T/2 k) (w - o)] / Ixx / (1 + T/2 c + T^2/4 k)
void RollBankObserver::predict(float lateral_force_mps2, float vertical_movement_m) {
    const float secant = 1.0F / bounded_cosine(within_model(phi_));
    const float dh = clamp_magnitude(vertical_movement_m, largest_movement_m);
    const float force =
        (force_to_acceleration_ - movement_to_acceleration_ * dh) * lateral_force_mps2 * secant;
    const float spring = stiffness_.moment_nm(phi_) * inverse_inertia_;
    tipped_ = tips(lateral_force_mps2, force - spring);
    const float k =
        larger(stiffness_.slope_nmprad(phi_) * inverse_inertia_ - force * secant * bounded_sine(phi_), 0.0F);
    const float c = damping_over_inertia_ + 0.5F * T * k;
    const float step = tipped_ ? 0.0F : T / (1.0F + 0.5F * T * c);

    const float roll_rate = rate_ - offset_;
    const float d = step * (force - spring - c * roll_rate);
    phi_ += T * (roll_rate + 0.5F * d);
    rate_ += d;
    bank_ += T * offset_;
    offset_ *= offset_decay;
    predict_covariance(step * k, step * c);
}

// P = F P F^T + Q with F = [[1 - T/2 s, T - T/2 e, 0, -(T - T/2 e)], [-s, 1 - e, 0, e], [0, 0, 1, T],
// [0, 0, 0, decay]].
void RollBankObserver::predict_covariance(float s, float e) {
    const float F11 = 1.0F - 0.5F * T * s;
    const float F12 = T - 0.5F * T * e;
    const float a1 = F11 * P11_ + F12 * (P12_ - P14_);
    const float a2 = F11 * P12_ + F12 * (P22_ - P24_);
    const float a3 = F11 * P13_ + F12 * (P23_ - P34_);
    const float a4 = F11 * P14_ + F12 * (P24_ - P44_);
    const float b1 = P12_ + e * (P14_ - P12_) - s * P11_;
    const float b2 = P22_ + e * (P24_ - P22_) - s * P12_;
    const float b3 = P23_ + e * (P34_ - P23_) - s * P13_;
    const float b4 = P24_ + e * (P44_ - P24_) - s * P14_;
    const float c3 = P33_ + T * P34_;
    const float c4 = P34_ + T * P44_;
    P11_ = F11 * a1 + F12 * (a2 - a4) + roll_noise_rad2;
    P12_ = a2 + e * (a4 - a2) - s * a1;
    P13_ = a3 + T * a4;
    P14_ = offset_decay * a4;
    P22_ = b2 + e * (b4 - b2) - s * b1 + rate_noise_rad2ps2;
    P23_ = b3 + T * b4;
    P24_ = offset_decay * b4;
    P33_ = c3 + T * c4 + bank_drift_variance_rad2_;
    P34_ = offset_decay * c4;
    P44_ = offset_decay * offset_decay * P44_ + offset_noise_rad2ps2;
}

// p = w
void RollBankObserver::correct_by_roll_rate(float roll_rate_radps) {
    correct(roll_rate_radps - rate_, P22_ + gyro_variance_rad2ps2, P12_, P22_, P23_, P24_);
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
    const float surprise = square(innovation * (1.0F / plausible_innovation_mps2));
    const float variance = square(deviation) * (1.0F + square(surprise));
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
    offset_ += k4 * innovation;
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
        phi_ + rate_ + bank_ + offset_ + P11_ + P12_ + P13_ + P14_ + P22_ + P23_ + P24_ + P33_ + P34_ + P44_;
    if (!is_finite(sum)) {
        reset();
        return;
    }
    phi_ = clamp_magnitude(phi_, largest_roll_rad);
    rate_ = clamp_magnitude(rate_, largest_rate_radps);
    bank_ = clamp_magnitude(bank_, largest_bank_rad);
    offset_ = clamp_magnitude(offset_, largest_offset_radps);
    P11_ = variance_within(P11_, 1.0F);
    P22_ = variance_within(P22_, 100.0F);
    P33_ = variance_within(P33_, square(initial_bank_rad));
    P44_ = variance_within(P44_, square(largest_offset_radps));
}

}  // namespace rsi
