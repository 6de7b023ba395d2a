// Driven world: a simulated vehicle in mixed driving and what its sensors report, cycle by cycle.
#pragma once

#include <cstdint>
#include <optional>

#include "sil/chance.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/sensors/sensor_suite.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// A vehicle that has rolled over is replaced by another one. Every few minutes, when it goes straight, it
// stops for a while; the tyre model wants a rolling wheel, so that is written down instead of driven.
class DrivenWorld {
 public:
    DrivenWorld(const VehicleParameters& vehicle, std::uint64_t seed, double duration_s);

    // The next cycle's sample; none while there is no vehicle.
    std::optional<SensorSample> next();

    bool stands() const { return stop_ && stop_speed_mps_ <= 0.0; }  // in the last cycle
    std::uint64_t rollovers() const { return rollovers_; }
    std::uint64_t stops() const { return stops_; }

 private:
    // The course of a stop: the speed falls, is zero, and rises.
    struct Stop {
        double speed_mps;
        double standing_s;
        double time_s{0.0};
    };

    void start();
    void step();
    bool goes_straight() const;
    void begin_stop_if_due();
    Truth stopping_truth();

    const VehicleParameters& vehicle_;
    std::uint64_t seed_;
    double duration_s_;
    Chance chance_;
    std::optional<ManoeuvreRun> plant_{};
    std::optional<SensorSuite> sensors_{};
    Truth shown_{};
    std::optional<Stop> stop_{};
    double stop_speed_mps_{0.0};
    double stopped_s_{0.0};  // in all: the plant's clock stands meanwhile
    double until_stop_s_{0.0};
    double straight_s_{0.0};
    std::uint64_t absent_{0U};
    std::uint64_t rollovers_{0U};
    std::uint64_t stops_{0U};
};

}  // namespace sil
