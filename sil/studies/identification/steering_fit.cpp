#include "sil/studies/identification/steering_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sil/studies/identification/least_squares.hpp"
#include "sil/studies/identification/zero_phase_filter.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double residual_correlation_s = 0.2;
// Tyres are linear up to about here.
constexpr double smallest_mps2 = 0.1 * g_mps2;
constexpr double largest_mps2 = 0.4 * g_mps2;
constexpr double speeds_apart = 1.4;  // so much faster is another speed
constexpr std::size_t fewest_samples = 50U;

bool usable(const RollSample& sample) {
    const double lateral = std::abs(sample.yaw_rate_radps * sample.speed_mps);
    return sample.speed_mps > slowest_ramp_mps && lateral > smallest_mps2 && lateral < largest_mps2;
}

struct Row {
    double steering;   // delta_sw
    double curvature;  // r / V
    double lateral;    // r V
    double rate;       // of the steering wheel: the yaw rate follows with a lag
};

std::vector<double> steering_rate(const PreparedDrive& drive) {
    std::vector<double> steering;
    for (const RollSample& sample : drive.samples) {
        steering.push_back(sample.steering_wheel_angle_rad);
    }
    return differentiate(steering, sample_time_s);
}

std::vector<Row> rows_of(const std::vector<PreparedDrive>& ramps, double fastest_radps) {
    std::vector<Row> rows;
    for (const PreparedDrive& drive : ramps) {
        if (!drive.has_steering) {
            continue;
        }
        const std::vector<double> rate = steering_rate(drive);
        for (std::size_t k = 0U; k < drive.samples.size(); ++k) {
            const RollSample& sample = drive.samples[k];
            if (usable(sample) && std::abs(rate[k]) < fastest_radps) {
                rows.push_back(Row{sample.steering_wheel_angle_rad, sample.yaw_rate_radps / sample.speed_mps,
                                   sample.yaw_rate_radps * sample.speed_mps, rate[k]});
            }
        }
    }
    return rows;
}

class SteeringProblem {
 public:
    SteeringProblem(const VehicleData& vehicle, std::vector<Row> rows)
        : vehicle_{vehicle}, rows_{std::move(rows)} {}

    SteeringFit solve() const {
        SteeringFit fit;
        if (vehicle_.steering_ratio && vehicle_.understeer_gradient_s2pm) {
            fit.ratio.value = *vehicle_.steering_ratio;
            fit.understeer_gradient_s2pm.value = *vehicle_.understeer_gradient_s2pm;
        } else if (vehicle_.steering_ratio) {
            fit_gradient(fit);
        } else if (vehicle_.understeer_gradient_s2pm || !several_speeds()) {
            fit_ratio(fit);
        } else {
            fit_both(fit);
        }
        judge(fit);
        return fit;
    }

 private:
    bool several_speeds() const {
        double slowest = 1.0e9, fastest = 0.0;
        for (const Row& row : rows_) {
            const double speed = std::sqrt(row.lateral / row.curvature);
            slowest = std::min(slowest, speed);
            fastest = std::max(fastest, speed);
        }
        return fastest > speeds_apart * slowest;
    }

    // y = x theta + lag rate; then again with the residual as what is not explained.
    template <typename X, typename Y>
    LinearFit regress(std::vector<Prior> priors, const X& x, const Y& y) const {
        priors.push_back({0.1, 0.1});
        double deviation = 0.05;
        LinearFit fit;
        for (int pass = 0; pass < 3; ++pass) {
            LinearProblem problem{priors};
            for (const Row& row : rows_) {
                problem.add(x(row), y(row), deviation, sample_time_s / residual_correlation_s);
            }
            fit = problem.solve();
            double squares = 0.0;
            for (const Row& row : rows_) {
                const double error = y(row) - x(row).dot(fit.value);
                squares += error * error;
            }
            deviation = std::max(0.003, std::sqrt(squares / static_cast<double>(rows_.size())));
        }
        return fit;
    }

    void fit_gradient(SteeringFit& fit) const {
        const double ratio = *vehicle_.steering_ratio;
        const LinearFit linear = regress(
            {{ratio * usual_understeer_gradient_s2pm, ratio * 0.01}},
            [](const Row& row) { return Eigen::VectorXd{Eigen::Vector2d{row.lateral, row.rate}}; },
            [&](const Row& row) { return row.steering - ratio * vehicle_.wheelbase_m * row.curvature; });
        fit.ratio.value = ratio;
        fit.understeer_gradient_s2pm = {linear.value[0] / ratio, linear.deviation[0] / ratio, 0.01};
        fit.lag_s = linear.value[1];
        fit.gradient_fitted = true;
    }

    void fit_ratio(SteeringFit& fit) const {
        const double gradient = vehicle_.understeer_gradient_s2pm.value_or(usual_understeer_gradient_s2pm);
        const LinearFit linear = regress(
            {{17.0, 10.0}},
            [&](const Row& row) {
                return Eigen::VectorXd{
                    Eigen::Vector2d{vehicle_.wheelbase_m * row.curvature + gradient * row.lateral, row.rate}};
            },
            [](const Row& row) { return row.steering; });
        fit.ratio = {linear.value[0], linear.deviation[0], 10.0};
        fit.understeer_gradient_s2pm.value = gradient;
        fit.lag_s = linear.value[1];
        fit.ratio_fitted = true;
    }

    void fit_both(SteeringFit& fit) const {
        const LinearFit linear = regress(
            {{17.0, 10.0}, {17.0 * usual_understeer_gradient_s2pm, 0.15}},
            [&](const Row& row) {
                return Eigen::VectorXd{
                    Eigen::Vector3d{vehicle_.wheelbase_m * row.curvature, row.lateral, row.rate}};
            },
            [](const Row& row) { return row.steering; });
        fit.ratio = {linear.value[0], linear.deviation[0], 10.0};
        fit.understeer_gradient_s2pm = {linear.value[1] / linear.value[0],
                                        linear.deviation[1] / linear.value[0], 0.15 / 17.0};
        fit.lag_s = linear.value[2];
        fit.ratio_fitted = true;
        fit.gradient_fitted = true;
    }

    void judge(SteeringFit& fit) const {
        double squares = 0.0, sum = 0.0, sum_of_squares = 0.0;
        for (const Row& row : rows_) {
            const double wheel = (row.steering - fit.lag_s * row.rate) / fit.ratio.value;
            const double error = wheel - vehicle_.wheelbase_m * row.curvature -
                                 fit.understeer_gradient_s2pm.value * row.lateral;
            squares += error * error;
            sum += wheel;
            sum_of_squares += wheel * wheel;
            fit.largest_used_mps2 = std::max(fit.largest_used_mps2, std::abs(row.lateral));
        }
        const double count = static_cast<double>(rows_.size());
        fit.rms_rad = std::sqrt(squares / count);
        fit.r_squared = 1.0 - squares / (sum_of_squares - sum * sum / count);
    }

    const VehicleData& vehicle_;
    std::vector<Row> rows_;
};

}  // namespace

std::optional<SteeringFit> fit_steering(const VehicleData& vehicle, const std::vector<PreparedDrive>& ramps) {
    std::vector<Row> rows = rows_of(ramps, fastest_ramp_steering_radps);
    if (rows.size() < fewest_samples) {
        return std::nullopt;
    }
    return SteeringProblem{vehicle, std::move(rows)}.solve();
}

NoSteering why_no_steering(const std::vector<PreparedDrive>& ramps) {
    if (std::none_of(ramps.begin(), ramps.end(),
                     [](const PreparedDrive& drive) { return drive.has_steering; })) {
        return NoSteering::not_recorded;
    }
    const auto of_any_rate = rows_of(ramps, std::numeric_limits<double>::infinity());
    return of_any_rate.size() < fewest_samples ? NoSteering::hardly_any_turn : NoSteering::too_fast;
}

}  // namespace sil
