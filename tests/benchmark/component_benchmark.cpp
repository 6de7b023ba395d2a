// Time of one step of the component over a manoeuvre that goes to the limits in both directions.
#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "rsi/component.hpp"
#include "tests/unit/support/nominal.hpp"
#include "tests/unit/support/random_manoeuvre.hpp"

namespace {

// One minute, prepared beforehand so that only the component is timed.
std::vector<rsi_inputs> one_minute() {
    rsi_test::RandomManoeuvre drive(rsi_test::large_suv(), 71U, false);
    std::vector<rsi_inputs> inputs;
    for (int k = 0; k < 6000; ++k) {
        inputs.push_back(drive.next());
    }
    return inputs;
}

void component_step(benchmark::State& state) {
    const std::vector<rsi_inputs> inputs = one_minute();
    rsi::Component component;
    component.init(rsi_test::large_suv());
    std::size_t k = 0;
    for (auto _ : state) {
        rsi_outputs outputs;
        component.step(inputs[k], outputs);
        benchmark::DoNotOptimize(outputs);
        k = (k + 1 < inputs.size()) ? k + 1 : 0;
    }
    state.counters["bytes"] = static_cast<double>(sizeof(rsi::Component));
    state.counters["times_real_time"] =
        benchmark::Counter(0.01, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(component_step);

// The least-squares update by itself, and the baseline that it is compared with: the same equations as a
// textbook writes them, with matrices of dynamic size and general products.
class TextbookLeastSquares {
 public:
    explicit TextbookLeastSquares(const rsi_parameters& p)
        : lambda_(p.forgetting_factor),
          scale_(p.regression_scale_nm),
          theta_(Eigen::VectorXf::Zero(3)),
          widths_(3),
          P_(Eigen::MatrixXf::Identity(3, 3)) {
        widths_ << p.initial_roll_centre_deviation_m, p.initial_stiffness_deviation_nmprad,
            p.initial_damping_deviation_nmsprad;
    }

    void update(const rsi::Regression& regression) {
        const Eigen::VectorXf psi = Eigen::VectorXf(regression.psi).cwiseProduct(widths_) / scale_;
        const float n_s = 1.0F + (psi.transpose() * P_ * psi).value();
        const float e = regression.output_nm / scale_ - psi.dot(theta_);
        P_ = (P_ - P_ * psi * psi.transpose() * P_ / (lambda_ * n_s + (psi.transpose() * P_ * psi).value())) /
             lambda_;
        theta_ += P_ * psi * e / n_s;
    }

    const Eigen::VectorXf& theta() const { return theta_; }

 private:
    float lambda_;
    float scale_;
    Eigen::VectorXf theta_;
    Eigen::VectorXf widths_;
    Eigen::MatrixXf P_;
};

std::vector<rsi::Regression> regressions() {
    rsi::RollPlaneModel model;
    model.init(rsi_test::large_suv());
    rsi::MeasurementStage stage;
    stage.init(rsi_test::large_suv());
    rsi::FixedModelRoll fixed;
    std::vector<rsi::Regression> all;
    for (const rsi_inputs& inputs : one_minute()) {
        rsi::Measurement measured;
        if (stage.update(inputs, measured)) {
            fixed.evaluate(model, measured);
            all.push_back(rsi::regress(model, measured, fixed));
            fixed.advance(model);
        }
    }
    return all;
}

void least_squares_textbook_baseline(benchmark::State& state) {
    const std::vector<rsi::Regression> all = regressions();
    TextbookLeastSquares estimator{rsi_test::large_suv()};
    std::size_t k = 0;
    for (auto _ : state) {
        estimator.update(all[k]);
        benchmark::DoNotOptimize(estimator.theta());
        k = (k + 1 < all.size()) ? k + 1 : 0;
    }
}
BENCHMARK(least_squares_textbook_baseline);

void least_squares_update(benchmark::State& state) {
    const std::vector<rsi::Regression> all = regressions();
    rsi::RobustLeastSquares estimator;
    estimator.init(rsi_test::large_suv());
    std::size_t k = 0;
    for (auto _ : state) {
        estimator.update(all[k]);
        benchmark::DoNotOptimize(estimator);
        k = (k + 1 < all.size()) ? k + 1 : 0;
    }
}
BENCHMARK(least_squares_update);

void component_init(benchmark::State& state) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi::Component component;
    for (auto _ : state) {
        rsi_validation answer = component.init(parameters);
        benchmark::DoNotOptimize(answer);
    }
}
BENCHMARK(component_init);

}  // namespace

BENCHMARK_MAIN();
