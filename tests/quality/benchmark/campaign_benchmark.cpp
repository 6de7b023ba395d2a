// Benchmark of a campaign's runs on one core: simulated seconds per second of runs driven together, as
// campaigns drive them, and of the same runs one by one as the baseline; and the same motions of the vehicle
// alone.
#include <benchmark/benchmark.h>

#include <optional>
#include <string>
#include <vector>

#include "sil/studies/campaign/campaign_run.hpp"

namespace {

constexpr std::uint64_t run_count = 400U;

// The built-in campaign, with paths that hold in any folder.
const sil::CampaignWorld& world() {
    static const sil::CampaignWorld built_in = [] {
        sil::CampaignSettings settings = sil::default_campaign();
        for (sil::CampaignVehicle& vehicle : settings.vehicles) {
            vehicle.parameters = std::string{RSI_SOURCE_DIR} + "/" + vehicle.parameters;
            vehicle.calibration = std::string{RSI_SOURCE_DIR} + "/" + vehicle.calibration;
        }
        return sil::CampaignWorld{settings};
    }();
    return built_in;
}

void count_time(benchmark::State& state, double simulated_s) {
    state.counters["runs"] = static_cast<double>(run_count);
    state.counters["times_real_time"] = benchmark::Counter(simulated_s, benchmark::Counter::kIsRate);
}

// One iteration is the first four hundred runs, each with its drawing, vehicle, sensors, frames, firmware,
// indices.
void campaign_runs(benchmark::State& state) {
    double simulated_s = 0.0;
    for (auto _ : state) {
        for (std::uint64_t number = 0U; number < run_count; ++number) {
            simulated_s += world().run(number).outcome.end_time_s;
        }
    }
    count_time(state, simulated_s);
}

// The same runs, eight at a time; its ratio to campaign_runs is what that is worth.
void campaign_runs_together(benchmark::State& state) {
    double simulated_s = 0.0;
    for (auto _ : state) {
        std::uint64_t number = 0U;
        world().run_together([&] { return number < run_count ? std::optional{number++} : std::nullopt; },
                             [&](const sil::CampaignRow& row) {
                                 simulated_s += row.outcome.end_time_s;
                                 return true;
                             });
    }
    count_time(state, simulated_s);
}

void the_same_by_the_vehicle_alone(benchmark::State& state) {
    std::vector<double> ends_s;
    for (std::uint64_t number = 0U; number < run_count; ++number) {
        ends_s.push_back(world().run(number).outcome.end_time_s);
    }
    double simulated_s = 0.0;
    for (auto _ : state) {
        for (std::uint64_t number = 0U; number < run_count; ++number) {
            const sil::DrawnRun drawn = world().prepare(number);
            sil::ManoeuvreRun plant{drawn.vehicle, drawn.manoeuvre, drawn.options};
            while (plant.truth().time_s < ends_s[number]) {
                plant.step();
            }
            simulated_s += plant.truth().time_s;
        }
    }
    count_time(state, simulated_s);
}

BENCHMARK(the_same_by_the_vehicle_alone)->Unit(benchmark::kMillisecond);
BENCHMARK(campaign_runs)->Unit(benchmark::kMillisecond);
BENCHMARK(campaign_runs_together)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
