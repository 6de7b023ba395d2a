// Response fit: how the lateral force follows what the steering asks for, from the drives.
#pragma once

#include <optional>
#include <vector>

#include "sil/studies/identification/prepared_drive.hpp"
#include "sil/studies/identification/roll_fit.hpp"

namespace sil {

// A'' = w^2 (a_d - A) - 2 zeta w A', a_d = V^2 delta / (L + K_us V^2) within what the tyres give.
//
// Fitted is what the component needs: the forecast of A over `response_horizon_s` that starts from A and A'
// as the component filters them, with the steering held. Therefore w and zeta contain these lags, and the
// driver's next action; they are no eigenvalues of the vehicle.
struct ResponseFit {
    double frequency_radps{};   // w
    double damping{};           // zeta
    double frequency_factor{};  // standard error of w as a factor
    double damping_factor{};
    double rms_mps2{};        // of the forecast
    double trend_rms_mps2{};  // of the forecast with which A goes on as it is going
    bool at_a_bound{false};   // of what is searched

    // A forecast that is no better than the trend is none.
    bool helps() const { return rms_mps2 < trend_rms_mps2; }
};

inline constexpr double response_horizon_s = 0.2;
inline constexpr double slowest_response_radps = 2.0;
inline constexpr double fastest_response_radps = 40.0;
inline constexpr double least_response_damping = 0.3;
inline constexpr double largest_response_damping = 2.0;

// Parts of a_d, and the lag of the component's filter of A.
struct SteeringModel {
    double wheelbase_m{};
    double ratio{};
    double understeer_gradient_s2pm{};
    double largest_mps2{};  // |a_d| stays within
    double filter_lag_s{};
};

double steering_demand_mps2(const SteeringModel& model, const RollSample& sample);

// From ramps and dynamic drives alike, where the steering asks for no more than 0.5 g. Nothing when no drive
// has steering, speed and yaw rate.
std::optional<ResponseFit> fit_response(const SteeringModel& model, const std::vector<PreparedDrive>& ramps,
                                        const std::vector<PreparedDrive>& dynamics);

}  // namespace sil
