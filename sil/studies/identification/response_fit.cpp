#include "sil/studies/identification/response_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sil/units.hpp"

namespace sil {
namespace {

// Priors: factors by which w and zeta of vehicles scatter about these.
constexpr double usual_frequency_radps = 8.0;
constexpr double usual_damping = 0.8;
constexpr double frequency_scatter = 0.5;  // of the logarithms
constexpr double damping_scatter = 0.3;

// As in the other fits: one independent observation in so long a time.
constexpr double forecast_correlation_s = 0.2;
constexpr double trend_s = 0.2;  // for the comparison: the trend of A dies away so
constexpr double slowest_forecast_mps = 5.0;
// A steering that asks for more bends the tyres: what comes then is less, not later.
constexpr double largest_demand_mps2 = 0.5 * g_mps2;
constexpr int response_reweightings = 4;
constexpr std::size_t fewest_forecasts = 100U;

// One forecast: from where, what the steering asks for, and what came.
struct Forecast {
    double force;   // A, filtered
    double rate;    // A', filtered
    double demand;  // a_d
    double later;   // A at the end
};

double within_reach(const Forecast& from, double force) {
    return std::clamp(force, std::min({from.force, from.demand, 0.0}),
                      std::max({from.force, from.demand, 0.0}));
}

// A - a_d and A' after the horizon, for a demand that stays: A - a_d = c_1 (A - a_d)(0) + c_2 A'(0).
class Response {
 public:
    Response(double frequency_radps, double damping) {
        const double s = damping * frequency_radps * response_horizon_s;
        const double square = std::pow(frequency_radps * response_horizon_s, 2) - s * s;
        // cos and sin x / x of what is under the root; with too much damping they are cosh and sinh x / x.
        const double x = std::sqrt(std::abs(square));
        const double even = square > 0.0 ? std::cos(x) : std::cosh(x);
        const double odd = x < 1.0e-6 ? 1.0 : (square > 0.0 ? std::sin(x) : std::sinh(x)) / x;
        from_difference_ = std::exp(-s) * (even + s * odd);
        from_rate_s_ = std::exp(-s) * odd * response_horizon_s;
    }

    double operator()(const Forecast& from) const {
        return within_reach(
            from, from.demand + from_difference_ * (from.force - from.demand) + from_rate_s_ * from.rate);
    }

 private:
    double from_difference_;
    double from_rate_s_;
};

double along_the_trend(const Forecast& from) {
    return within_reach(from,
                        from.force + from.rate * trend_s * (1.0 - std::exp(-response_horizon_s / trend_s)));
}

// As RollMotionFilter of the component: two lags, and one more on the derivative.
void add_forecasts(const SteeringModel& model, const PreparedDrive& drive, std::vector<Forecast>& forecasts) {
    constexpr auto ahead = static_cast<std::size_t>(response_horizon_s / sample_time_s + 0.5);
    if (!drive.has_steering || drive.samples.empty()) {
        return;
    }
    const double weight =
        model.filter_lag_s > 0.0 ? 1.0 - std::exp(-sample_time_s / model.filter_lag_s) : 1.0;
    double first = drive.samples.front().parallel_mps2, second = first, rate = 0.0;
    for (std::size_t k = 0U; k + ahead < drive.samples.size(); ++k) {
        const RollSample& sample = drive.samples[k];
        first += weight * (sample.parallel_mps2 - first);
        const double change = weight * (first - second);
        second += change;
        rate += weight * (change / sample_time_s - rate);
        const double demand = steering_demand_mps2(model, sample);
        if (sample.speed_mps > slowest_forecast_mps && std::abs(demand) < largest_demand_mps2) {
            forecasts.push_back({second, rate, demand, drive.samples[k + ahead].parallel_mps2});
        }
    }
}

template <typename Method>
double mean_square(const std::vector<Forecast>& forecasts, const Method& method) {
    double squares = 0.0;
    for (const Forecast& forecast : forecasts) {
        const double error = method(forecast) - forecast.later;
        squares += error * error;
    }
    return squares / static_cast<double>(forecasts.size());
}

// The logarithms of w and zeta.
using Logarithms = std::array<double, 2>;

class ResponseProblem {
 public:
    explicit ResponseProblem(const std::vector<Forecast>& forecasts) : forecasts_{forecasts} {}

    ResponseFit solve() {
        variance_ = mean_square(forecasts_, along_the_trend);
        Logarithms best{};
        for (int pass = 0; pass < response_reweightings; ++pass) {
            best = least();
            variance_ = std::max(mean_square_of(best), 1.0e-6);
        }
        ResponseFit fit;
        fit.frequency_radps = std::exp(best[0]);
        fit.damping = std::exp(best[1]);
        fit.rms_mps2 = std::sqrt(mean_square_of(best));
        fit.trend_rms_mps2 = std::sqrt(mean_square(forecasts_, along_the_trend));
        fit.at_a_bound = !inside(best);
        add_deviations(best, fit);
        return fit;
    }

 private:
    static constexpr double finest = 0.002;

    static Logarithms lowest() {
        return {std::log(slowest_response_radps), std::log(least_response_damping)};
    }
    static Logarithms highest() {
        return {std::log(fastest_response_radps), std::log(largest_response_damping)};
    }

    static bool inside(const Logarithms& at) {
        return at[0] > lowest()[0] + finest && at[0] < highest()[0] - finest &&
               at[1] > lowest()[1] + finest && at[1] < highest()[1] - finest;
    }

    double mean_square_of(const Logarithms& at) const {
        return mean_square(forecasts_, Response{std::exp(at[0]), std::exp(at[1])});
    }

    // Twice the negative logarithm of the probability.
    double misfit(const Logarithms& at) const {
        const double independent =
            static_cast<double>(forecasts_.size()) * sample_time_s / forecast_correlation_s;
        const double w = (at[0] - std::log(usual_frequency_radps)) / frequency_scatter;
        const double zeta = (at[1] - std::log(usual_damping)) / damping_scatter;
        return independent * mean_square_of(at) / variance_ + w * w + zeta * zeta;
    }

    // On a grid, and then on ever finer ones around its best point: there may be more than one valley.
    Logarithms least() const {
        Logarithms step{(highest()[0] - lowest()[0]) / 20.0, (highest()[1] - lowest()[1]) / 10.0};
        Logarithms best{};
        double least = std::numeric_limits<double>::infinity();
        const auto look = [&](const Logarithms& at) {
            const double here = misfit(at);
            if (here < least) {
                least = here;
                best = at;
            }
        };
        for (int i = 0; i <= 20; ++i) {
            for (int j = 0; j <= 10; ++j) {
                look({lowest()[0] + i * step[0], lowest()[1] + j * step[1]});
            }
        }
        while (step[0] > finest) {
            step = {0.5 * step[0], 0.5 * step[1]};
            const Logarithms centre = best;
            for (int i = -1; i <= 1; ++i) {
                for (int j = -1; j <= 1; ++j) {
                    look({std::clamp(centre[0] + i * step[0], lowest()[0], highest()[0]),
                          std::clamp(centre[1] + j * step[1], lowest()[1], highest()[1])});
                }
            }
        }
        return best;
    }

    // From the curvature of the misfit.
    void add_deviations(const Logarithms& at, ResponseFit& fit) const {
        constexpr double step = 0.05;
        const auto shifted = [&](double w, double zeta) {
            return misfit({at[0] + w * step, at[1] + zeta * step});
        };
        const double scale = 1.0 / (2.0 * step * step);
        const double ww = scale * (shifted(1, 0) - 2.0 * shifted(0, 0) + shifted(-1, 0));
        const double zz = scale * (shifted(0, 1) - 2.0 * shifted(0, 0) + shifted(0, -1));
        const double wz = 0.25 * scale * (shifted(1, 1) - shifted(1, -1) - shifted(-1, 1) + shifted(-1, -1));
        const double determinant = ww * zz - wz * wz;
        const bool bowl = ww > 0.0 && determinant > 0.0;
        fit.frequency_factor = std::exp(bowl ? std::sqrt(zz / determinant) : frequency_scatter);
        fit.damping_factor = std::exp(bowl ? std::sqrt(ww / determinant) : damping_scatter);
    }

    const std::vector<Forecast>& forecasts_;
    double variance_{1.0};
};

}  // namespace

double steering_demand_mps2(const SteeringModel& model, const RollSample& sample) {
    const double square = sample.speed_mps * sample.speed_mps;
    const double divisor_m = std::max(model.wheelbase_m + model.understeer_gradient_s2pm * square,
                                      0.1 * model.wheelbase_m);  // as the component bounds it
    return std::clamp(square * sample.steering_wheel_angle_rad / model.ratio / divisor_m, -model.largest_mps2,
                      model.largest_mps2);
}

std::optional<ResponseFit> fit_response(const SteeringModel& model, const std::vector<PreparedDrive>& ramps,
                                        const std::vector<PreparedDrive>& dynamics) {
    std::vector<Forecast> forecasts;
    for (const auto* drives : {&ramps, &dynamics}) {
        for (const PreparedDrive& drive : *drives) {
            add_forecasts(model, drive, forecasts);
        }
    }
    if (forecasts.size() < fewest_forecasts) {
        return std::nullopt;
    }
    return ResponseProblem{forecasts}.solve();
}

}  // namespace sil
