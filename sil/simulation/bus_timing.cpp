#include "sil/simulation/bus_timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "sil/files/sensor_frame.hpp"
#include "sil/simulation/simulation.hpp"

namespace sil {
namespace {

constexpr double cycle_ms = 10.0;

double milliseconds(rsi::hal::Time time) {
    return static_cast<double>(time.nanoseconds) * 1.0e-6;
}

// The value that `share` of the sorted values do not exceed.
double quantile(const std::vector<double>& sorted, double share) {
    const double rank = std::ceil(share * static_cast<double>(sorted.size()));
    const std::size_t index = static_cast<std::size_t>(std::max(rank, 1.0)) - 1U;
    return sorted[std::min(index, sorted.size() - 1U)];
}

std::optional<DurationStatistics> statistics(std::vector<double> durations_ms) {
    if (durations_ms.empty()) {
        return std::nullopt;
    }
    std::sort(durations_ms.begin(), durations_ms.end());
    return DurationStatistics{quantile(durations_ms, 0.5), quantile(durations_ms, 0.99), durations_ms.back()};
}

std::string describe(const char* what, const std::optional<DurationStatistics>& statistics) {
    if (!statistics) {
        return fmt::format("  {:<32} not to be seen in this log\n", what);
    }
    return fmt::format("  {:<32} median {:.3f} ms, 99th percentile {:.3f} ms, largest {:.3f} ms\n", what,
                       statistics->median_ms, statistics->percentile_99_ms, statistics->largest_ms);
}

}  // namespace

BusTiming bus_timing(const std::vector<LoggedFrame>& log) {
    BusTiming timing;
    std::vector<double> jitter_ms;
    std::vector<double> reaction_ms;
    std::optional<rsi::hal::Time> first_warning;
    std::optional<rsi::hal::Time> last_warning;
    rsi::hal::Time last_sensor{};
    bool is_answered = true;
    for (const LoggedFrame& logged : log) {
        const rsi::hal::Time time = logged.frame.receive_time;
        if (logged.frame.identifier == simulation_dbc::SimulationSync::identifier) {
            throw NoTiming{
                "this is the log of a run in lock-step (it has SimulationSync frames), so it has no real "
                "times; "
                "take one of a run in real time"};
        }
        if (is_sensor_frame(logged.frame)) {
            last_sensor = time;
            is_answered = false;
        } else if (logged.frame.identifier == rsi::can_dbc::RolloverWarning::identifier) {
            ++timing.warning_frames;
            if (last_warning) {
                jitter_ms.push_back(std::abs(milliseconds(time - *last_warning) - cycle_ms));
            }
            if (!is_answered) {
                reaction_ms.push_back(milliseconds(time - last_sensor));
                is_answered = true;
            }
            first_warning = first_warning.value_or(time);
            last_warning = time;
        }
    }
    if (!first_warning) {
        throw NoTiming{
            fmt::format("there is no warning frame (0x{:03X}) in this log: did an ECU run on this bus?",
                        rsi::can_dbc::RolloverWarning::identifier)};
    }
    timing.duration_s = 1.0e-3 * milliseconds(*last_warning - *first_warning);
    timing.cycle_jitter = statistics(std::move(jitter_ms));
    timing.reaction_time = statistics(std::move(reaction_ms));
    return timing;
}

std::string describe(const BusTiming& timing) {
    return fmt::format("  {:<32} {} in {:.2f} s\n", "warning frames on the bus", timing.warning_frames,
                       timing.duration_s) +
           describe("cycle jitter", timing.cycle_jitter) +
           describe("sensor frame to warning frame", timing.reaction_time);
}

}  // namespace sil
