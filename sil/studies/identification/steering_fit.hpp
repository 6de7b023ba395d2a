// Steering fit: understeer gradient and steering ratio from yaw rate, speed and steering-wheel angle.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sil/studies/identification/prepared_drive.hpp"
#include "sil/studies/identification/roll_fit.hpp"

namespace sil {

// (delta_sw - lag delta_sw') / i = r (L/V + K_us V), at small lateral acceleration.
struct SteeringFit {
    Estimate ratio;                     // i; deviation 0: given
    Estimate understeer_gradient_s2pm;  // K_us; deviation 0: given or assumed
    bool ratio_fitted{false};
    bool gradient_fitted{false};
    double lag_s{};    // by which the yaw rate follows the steering
    double rms_rad{};  // at the front wheels
    double r_squared{};
    double largest_used_mps2{};  // |r V|
};

// From the ramps that have steering, speed and yaw rate; nothing when none has. At one speed the data
// determine ratio or gradient, not both: with neither given, the gradient is the usual one.
std::optional<SteeringFit> fit_steering(const VehicleData& vehicle, const std::vector<PreparedDrive>& ramps);

inline constexpr double slowest_ramp_mps = 5.0;
inline constexpr double fastest_ramp_steering_radps = 0.4;  // at the steering wheel: faster is no ramp

// Result of ramps from which nothing was fitted.
enum class NoSteering : std::uint8_t { not_recorded, too_fast, hardly_any_turn };
NoSteering why_no_steering(const std::vector<PreparedDrive>& ramps);

inline constexpr double usual_understeer_gradient_s2pm = 0.0025;

}  // namespace sil
