// Benchmark of the whole loop without CAN hardware: vehicle, sensors, frames, firmware, frames, in one
// process.
#include <benchmark/benchmark.h>

#include "sil/files/calibration_file.hpp"
#include "sil/simulation/in_process_run.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace {

// One iteration is one whole run; steps of 1 ms, cycles of 10 ms.
void drive(benchmark::State& state, const char* name, bool noise) {
    const sil::VehicleParameters vehicle = sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/large_suv.toml");
    const rsi::Parameters calibration =
        sil::load_calibration(RSI_SOURCE_DIR "/firmware/calibrations/large_suv.toml");
    const sil::Manoeuvre manoeuvre = sil::find_manoeuvre(name);
    double simulated_s = 0.0;
    for (auto _ : state) {
        sil::InProcessRun run{vehicle, manoeuvre, {}, sil::mounted_sensors(vehicle, {noise}), calibration};
        benchmark::DoNotOptimize(run.run());
        simulated_s += run.truth().time_s;
    }
    state.counters["times_real_time"] = benchmark::Counter(simulated_s, benchmark::Counter::kIsRate);
}

void j_turn_45(benchmark::State& state) {
    drive(state, "j-turn-45", false);
}
void j_turn_110(benchmark::State& state) {
    drive(state, "j-turn-110", false);
}
void slalom_with_noise(benchmark::State& state) {
    drive(state, "slalom", true);
}

BENCHMARK(j_turn_45)->Unit(benchmark::kMillisecond);
BENCHMARK(j_turn_110)->Unit(benchmark::kMillisecond);
BENCHMARK(slalom_with_noise)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
