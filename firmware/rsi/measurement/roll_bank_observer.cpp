#include "rsi/measurement/roll_bank_observer.hpp"
#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/numeric/square.hpp"

namespace rsi {
namespace {

constexpr float radians(float degrees) {
    return degrees * 0.017453293F;
}

constexpr float T = sample_time_s;
constexpr float offset_decay = 1.0F - T / 0.6F;

// Beyond these the suspension's curve, or the sensor, means nothing.
constexpr float largest_movement_m = 0.05F;
constexpr float largest_roll_rad = 1.57F;
constexpr float largest_bank_rad = 0.5F;

// Below this speed a wheel-speed signal is poor and has no sign, so the turn says nothing about the bank.
constexpr float smallest_speed_mps = 5.0F;
constexpr DerivativeLag yaw_acceleration_lag{0.1F};

// v_y' is no white noise: it lasts for many samples, so it counts as more than it is.
constexpr float turn_deviation_mps2 = 6.0F;
constexpr float turn_deviation_per_yaw_acceleration_m = 7.0F;
// A larger one comes from a vehicle that slides, not from a road that has suddenly tilted.
constexpr float plausible_innovation_mps2 = 2.0F;

// Samples for which a body may fall back onto its wheels.
constexpr std::uint32_t longest_fall = 100U;

// Variances at the start, and bounds.
constexpr float initial_roll_variance_rad2 = square(0.05F);
constexpr float initial_bank_variance_rad2 = square(0.1F);
constexpr float smallest_roll_variance_rad2 = 1.0e-9F;

// sin x to within 2e-4 up to 1 rad; finite and of the right sign up to 3 rad.
float short_sine(float x) {
    const float z = x * x;
    return x * (1.0F + z * (-1.0F / 6.0F + z * (1.0F / 120.0F)));
}

// 1 / cos x to within 2e-3 up to 0.5 rad; finite beyond.
float short_secant(float x) {
    const float z = x * x;
    return 1.0F + z * (0.5F + z * (5.0F / 24.0F));
}

}  // namespace

// Noise of the model and of the measurements, tuned on simulated drives; variances of one step.
ObserverNoise observer_noise(const Parameters& parameters) {
    ObserverNoise noise{};
    noise.roll_rad2 = 9.0e-5F * T;
    noise.rate_rad2ps2 = 0.36F * T;
    noise.bank_rad2 = square(parameters.observer_bank_drift_radps) * T;
    noise.offset_rad2ps2 = square(radians(2.0F)) * T;
    noise.offset_decay = offset_decay;
    noise.gyro_rad2ps2 = square(radians(0.45F));
    noise.turn_mps2_2 = square(turn_deviation_mps2);
    return noise;
}

UprightRoll upright_roll(const Parameters& parameters) {
    const float inverse_inertia = 1.0F / parameters.roll_inertia_kgm2;
    const float k = inverse_inertia * parameters.roll_stiffness_nmprad;
    const float c = parameters.roll_damping_nmsprad * inverse_inertia + 0.5F * T * k;
    const float step = T / (1.0F + 0.5F * T * c);
    return UprightRoll{step * k, step * c};
}

RollBankObserver::Constants::Constants(const Parameters& parameters, const ObserverGains& settled_gains)
    : tipping_force_mps2(gravity_mps2 * static_stability_factor(parameters)), gains(settled_gains) {
    const float H = roll_arm_m(parameters);
    const float inverse_inertia = 1.0F / parameters.roll_inertia_kgm2;
    stiffness_over_inertia = RollStiffnessCurve{parameters, inverse_inertia};
    movement_to_acceleration = parameters.sprung_mass_kg * inverse_inertia;
    force_to_acceleration = movement_to_acceleration * H;
    damping_over_inertia = parameters.roll_damping_nmsprad * inverse_inertia;
}

void RollBankObserver::update(const Constants& constants, const Signals& signals, float vertical_movement_m) {
    if (!running_) {
        begin_in_balance(constants, signals.lateral_force_mps2, signals.roll_rate_radps);
        return;
    }
    predict(constants, signals.lateral_force_mps2, vertical_movement_m);
    correct_by_roll_rate(constants.gains, signals.roll_rate_radps);
    const float yaw_acceleration_radps2 =
        yaw_acceleration_.update(yaw_acceleration_lag, signals.yaw_rate_radps);
    // P33 tends to that of the steady filter from above.
    P33_ = smaller(P33_ + constants.gains.bank_growth_rad2, initial_bank_variance_rad2);
    if ((tipped_ == 0U) && (signals.speed_mps > smallest_speed_mps)) {
        correct_by_turn(constants.gains,
                        signals.lateral_force_mps2 - signals.yaw_rate_radps * signals.speed_mps,
                        yaw_acceleration_radps2);
    }
    keep_in_bounds();
}

// On a level road; the angle is not known yet.
void RollBankObserver::begin_in_balance(const Constants& constants, float lateral_force_mps2,
                                        float roll_rate_radps) {
    const float linear_angle_rad = constants.force_to_acceleration * lateral_force_mps2 /
                                   constants.stiffness_over_inertia.slope_nmprad(0.0F);
    state_ << clamp_magnitude(linear_angle_rad, 0.2F), roll_rate_radps, 0.0F, 0.0F;
    stiffness_step_ = 0.0F;
    P11_ = initial_roll_variance_rad2;
    P33_ = initial_bank_variance_rad2;
    yaw_acceleration_.reset();
    tipped_ = 0U;
    running_ = true;
}

// The inner wheels have lifted, so the suspension no longer holds the body: from the force that tips the
// standing vehicle until the body has come back to where the suspension would hold it. Without half that
// force it falls back at 3 rad/s^2: if that lasts, it has.
std::uint32_t RollBankObserver::tipped_for(const Constants& constants, float lateral_force_mps2,
                                           float roll_acceleration_radps2) const {
    const float force = absolute(lateral_force_mps2);
    if ((force > constants.tipping_force_mps2) && (P11_ < largest_roll_variance_rad2)) {
        return longest_fall;
    }
    if ((tipped_ == 0U) || (state_(State::roll) * roll_acceleration_radps2 >= 0.0F)) {
        return 0U;
    }
    return (force < 0.5F * constants.tipping_force_mps2) ? tipped_ - 1U : longest_fall;
}

// Trapezoidal rule with the local stiffness k, stable for any admitted parameters:
//   phi+ = phi + T (w - o) + T/2 d,  w+ = w + d,  b+ = b + T o,  o+ = decay o,
//   d = T [m_s H f_yb / cos phi - M - (c + T/2 k) (w - o)] / Ixx / (1 + T/2 c + T^2/4 k)
void RollBankObserver::predict(const Constants& constants, float lateral_force_mps2,
                               float vertical_movement_m) {
    const float moved_force_to_acceleration =  // m_s (H - dh) / Ixx
        constants.force_to_acceleration -
        constants.movement_to_acceleration * clamp_magnitude(vertical_movement_m, largest_movement_m);
    const float phi = state_(State::roll);
    const float offset = state_(State::offset);
    const float force = moved_force_to_acceleration * lateral_force_mps2 * short_secant(phi);
    const float spring = constants.stiffness_over_inertia.moment_nm(phi);
    tipped_ = tipped_for(constants, lateral_force_mps2, force - spring);
    const float k = larger(constants.stiffness_over_inertia.slope_nmprad(phi) - force * phi, 0.0F);
    const float c = constants.damping_over_inertia + 0.5F * T * k;
    const float step = (tipped_ > 0U) ? 0.0F : T / (1.0F + 0.5F * T * c);

    const float roll_rate = state_(State::rate) - offset;
    const float d = step * (force - spring - c * roll_rate);
    state_ += Vector4{T * (roll_rate + 0.5F * d), d, T * offset, (offset_decay - 1.0F) * offset};
    stiffness_step_ = step * k;
}

// p = w
void RollBankObserver::correct_by_roll_rate(const ObserverGains& gains, float roll_rate_radps) {
    const float s = stiffness_step_;
    const float covariance = gains.roll_rate_covariance - s * P11_;
    Vector4 gain = gains.gyro;
    gain(State::roll) = covariance / (gains.rate_variance + s * s * P11_);
    state_ += gain * (roll_rate_radps - state_(State::rate));
    P11_ += gains.roll_growth_rad2 - gain(State::roll) * covariance;
    P11_ = larger(P11_, smallest_roll_variance_rad2);
}

// f_yb - r V = g sin(phi + b) + v_y'
void RollBankObserver::correct_by_turn(const ObserverGains& gains, float gravity_part_mps2,
                                       float yaw_acceleration_radps2) {
    const float deviation =
        turn_deviation_mps2 + turn_deviation_per_yaw_acceleration_m * absolute(yaw_acceleration_radps2);
    const float innovation =
        gravity_part_mps2 - gravity_mps2 * short_sine(state_(State::roll) + state_(State::bank));
    const float surprise = square(innovation / plausible_innovation_mps2);
    const float variance = square(deviation) * (1.0F + square(surprise));
    Vector4 covariance = gains.turn;
    covariance(State::bank) += gravity_mps2 * P33_;
    const float weight =
        1.0F / (gravity_mps2 * (covariance(State::roll) + covariance(State::bank)) + variance);
    state_ += covariance * (weight * innovation);
    P33_ -= square(covariance(State::bank)) * weight;
}

// Every signal moves phi, so a number that is not finite shows there.
void RollBankObserver::keep_in_bounds() {
    float& phi = state_(State::roll);
    if (!is_within_magnitude(phi, largest_roll_rad)) {
        running_ = is_finite(phi);
        phi = clamp_magnitude(phi, largest_roll_rad);
    }
    state_(State::bank) = clamp_magnitude(state_(State::bank), largest_bank_rad);
}

}  // namespace rsi
