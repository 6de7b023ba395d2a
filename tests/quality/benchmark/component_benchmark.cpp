// Time of one step of the component over a manoeuvre that goes to the limits in both directions.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

#include "rsi/component.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/random_manoeuvre.hpp"
#include "tests/rsi/support/stages.hpp"
#include "tests/support/textbook_least_squares.hpp"

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

// The least-squares update by itself, and the baseline that it is compared with.
std::vector<rsi::Regression> regressions() {
    const rsi::Vehicle vehicle{rsi_test::large_suv()};
    rsi_test::MeasurementStage stage;
    stage.init(rsi_test::large_suv());
    rsi::FixedModelRoll fixed;
    std::vector<rsi::Regression> all;
    for (const rsi_inputs& inputs : one_minute()) {
        rsi::Measurement measured;
        if (stage.update(inputs, measured)) {
            fixed.update(vehicle, measured);
            all.push_back(rsi::regress(vehicle, measured, fixed));
        }
    }
    return all;
}

void least_squares_textbook_baseline(benchmark::State& state) {
    const std::vector<rsi::Regression> all = regressions();
    rsi_test::TextbookLeastSquares estimator{rsi_test::large_suv()};
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
    rsi_test::RobustLeastSquares estimator;
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
