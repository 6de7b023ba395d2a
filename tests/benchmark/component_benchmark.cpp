// Time of one step of the component over a manoeuvre that goes to the limits in both directions.
#include <benchmark/benchmark.h>

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
