// ExampleRun: a roll-plane caricature of a J-turn, good enough to have something to analyse and to draw.
#pragma once

#include <filesystem>

#include "sil/results/events.hpp"

namespace example_run {

struct Options {
    double direction{1.0};               // 1: left turn, -1: right turn
    double steady_acceleration_g{0.95};  // 0.95 rolls over, 0.68 does not
    double noise_share{0.0};             // 1: the preset of ordinary sensors
    double duration_s{3.0};
};

inline constexpr double static_stability_factor = 0.81;

// Simulates in steps of 1 ms, writes signals.csv and events.gp into the folder and returns the events.
sil::RunEvents write(const Options& options, const std::filesystem::path& folder);

}  // namespace example_run
