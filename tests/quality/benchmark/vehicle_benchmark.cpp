// Benchmark of the plant alone: time of one step, straight ahead and in a hard turn; of a step of several
// vehicles together; and the floating-point operations of a step beside what the core can do.
#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "tests/quality/benchmark/counted.hpp"  // before the equations
//

#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/vehicle/parameter_file.hpp"
#include "sil/world/vehicle/vehicle_batch.hpp"

namespace {

void drive(benchmark::State& state, const char* name) {
    const sil::VehicleParameters parameters =
        sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/large_suv.toml");
    const sil::Manoeuvre manoeuvre = sil::find_manoeuvre(name);
    sil::ManoeuvreRun run{parameters, manoeuvre};
    for (auto _ : state) {
        run.step();
        benchmark::DoNotOptimize(run.truth());
    }
    const double simulated_s = static_cast<double>(state.iterations()) * sil::Vehicle::nominal_step_s;
    state.counters["times_real_time"] = benchmark::Counter(simulated_s, benchmark::Counter::kIsRate);
}

void straight_ahead(benchmark::State& state) {
    drive(state, "straight");
}
void steady_turn(benchmark::State& state) {
    drive(state, "j-turn-45");
}
void slalom(benchmark::State& state) {
    drive(state, "slalom");
}

// As many as there are lanes, each somewhere else in the slalom. Drivers and roads are those of each vehicle.
void slaloms_together(benchmark::State& state) {
    const sil::VehicleParameters parameters =
        sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/large_suv.toml");
    const sil::Manoeuvre manoeuvre = sil::find_manoeuvre("slalom");
    sil::VehicleBatch batch;
    std::vector<std::unique_ptr<sil::ManoeuvreRun>> runs;
    for (std::size_t lane = 0U; lane < sil::lane_count; ++lane) {
        runs.push_back(std::make_unique<sil::ManoeuvreRun>(parameters, manoeuvre));
        for (std::size_t step = 0U; step < 500U * lane; ++step) {
            runs.back()->step();
        }
        batch.enter(lane, runs.back()->vehicle_to_step());
    }
    std::array<sil::DriverInput, sil::lane_count> inputs{};
    for (auto _ : state) {
        for (std::size_t lane = 0U; lane < sil::lane_count; ++lane) {
            inputs[lane] = runs[lane]->next_input();
        }
        batch.step(inputs, sil::Vehicle::nominal_step_s, sil::VehicleBatch::TruthWanted::motion);
        benchmark::DoNotOptimize(runs.front()->truth());
    }
    const auto steps = static_cast<double>(state.iterations()) * static_cast<double>(sil::lane_count);
    const double operations = counted::operations_of_a_step(parameters);
    state.counters["times_real_time"] =
        benchmark::Counter(steps * sil::Vehicle::nominal_step_s, benchmark::Counter::kIsRate);
    state.counters["operations_a_step"] = operations;
    state.counters["operations"] = benchmark::Counter(steps * operations, benchmark::Counter::kIsRate);
}

// Multiplications and additions that do not wait for each other, not fused, as the plant's are not either.
using Register = double __attribute__((vector_size(64)));
constexpr int chains = 12;
constexpr int rounds = 1000;

[[gnu::always_inline]] inline double multiply_and_add() {
    Register values[chains];
    for (int i = 0; i < chains; ++i) {
        values[i] = Register{} + (1.0 + i);
    }
    for (int round = 0; round < rounds; ++round) {
#pragma GCC unroll 12
        for (int i = 0; i < chains; ++i) {
            values[i] = values[i] * 0.999 + 0.001;
        }
    }
    double sum = 0.0;
    for (const Register& value : values) {
        sum += value[0];
    }
    return sum;
}
#ifdef __x86_64__
[[gnu::target("avx512f")]] double peak_avx512() {
    return multiply_and_add();
}
[[gnu::target("avx2")]] double peak_avx2() {
    return multiply_and_add();
}
#endif

void peak_of_the_core(benchmark::State& state) {
    double (*peak)() = [] { return multiply_and_add(); };
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx512f")) {
        peak = peak_avx512;
    } else if (__builtin_cpu_supports("avx2")) {
        peak = peak_avx2;
    }
#endif
    for (auto _ : state) {
        benchmark::DoNotOptimize(peak());
    }
    const double operations = 2.0 * 8.0 * chains * rounds * static_cast<double>(state.iterations());
    state.counters["operations"] = benchmark::Counter(operations, benchmark::Counter::kIsRate);
}

BENCHMARK(straight_ahead);
BENCHMARK(steady_turn);
BENCHMARK(slalom);
BENCHMARK(slaloms_together);
BENCHMARK(peak_of_the_core);

}  // namespace

BENCHMARK_MAIN();
