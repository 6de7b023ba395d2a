#include "rsi/prediction/linear_forecast.hpp"

#include <array>

#include "rsi/measurement/plausible_motion.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/two_lags.hpp"
#include "rsi/prediction/forecast_weights.hpp"

namespace rsi {
namespace {

constexpr Eigen::Index signals = ForecastMatrix::RowsAtCompileTime;
constexpr Eigen::Index lags = ForecastMatrix::ColsAtCompileTime;

// The later ones say what was a moment ago.
constexpr std::array<float, 3> weights_of_lags{lag_weight(0.02F), lag_weight(0.06F), lag_weight(0.15F)};

// More than any tyre gives.
constexpr float largest_forecast_force_mps2 = 20.0F;
// Bounds the yaw rate, so that a wrong one cannot outweigh the force.
constexpr float largest_yaw_difference_mps2 = 4.0F;

}  // namespace

float LinearForecast::update(const Vehicle& vehicle, const Inputs& inputs, const Measurement& measured,
                             const DemandedForce& demand) {
    const LoadedBody& loaded = vehicle.loaded;
    const float A = measured.road_parallel_force_mps2;
    const bool yaw_is_known = is_within_magnitude(inputs.yaw_rate_radps, largest_plausible_rate_radps) &&
                              is_within_magnitude(inputs.speed_mps, largest_plausible_speed_mps);
    const float yawed_mps2 = yaw_is_known ? inputs.yaw_rate_radps * inputs.speed_mps : A;
    const float beyond_force_mps2 = clamp_magnitude(yawed_mps2 - A, largest_yaw_difference_mps2);

    // In shares of what lifts the wheels; the roll rate in rad/s. The half weight is more than zero.
    const float per_nm = 1.0F / (gravity_mps2 * loaded.half_weight_kgm);
    const float per_mps2 = loaded.height_moment_kgm * per_nm;
    const std::array<float, 5> now{
        per_mps2 * clamp_magnitude(A, largest_forecast_force_mps2),
        measured.roll_rate_radps,
        vehicle.suspension.stiffness_nmprad * measured.roll_angle_rad * per_nm,
        per_mps2 * clamp_magnitude(A + beyond_force_mps2, largest_forecast_force_mps2),
        per_mps2 * clamp_magnitude(demand.force_mps2, largest_forecast_force_mps2),
    };
    const std::array<bool, 5> is_known{true, true, true, yaw_is_known, demand.is_known};

    float forecast = 0.0F;
    for (Eigen::Index signal = 0; signal < signals; ++signal) {
        const auto row = static_cast<std::size_t>(signal);
        for (Eigen::Index lag = 0; lag < lags; ++lag) {
            const auto column = static_cast<std::size_t>(lag);
            float& lagged = lagged_(signal, lag);
            if (!is_known[row]) {
                lagged = lagged_(0, lag);  // the force's past, too: a step would look like a motion
            } else if (running_) {
                lagged += weights_of_lags[column] * (now[row] - lagged);
            } else {
                lagged = now[row];
            }
            forecast += forecast_weights[row][column] * lagged;
        }
    }
    running_ = true;
    return forecast;
}

}  // namespace rsi
