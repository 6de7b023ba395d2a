// Benchmark of the plant alone: time of one step, straight ahead and in a hard turn.
#include <benchmark/benchmark.h>

#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

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

BENCHMARK(straight_ahead);
BENCHMARK(steady_turn);
BENCHMARK(slalom);

}  // namespace

BENCHMARK_MAIN();
