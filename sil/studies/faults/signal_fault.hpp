// Signal fault: a sensor whose value is wrong, or several that fail together; their frames are protected as
// ever.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sil/studies/faults/fault.hpp"
#include "sil/studies/faults/sensor_signal.hpp"
#include "sil/world/sensors/noise_source.hpp"

namespace sil {

class SignalFault {
 public:
    // A fault of another kind changes nothing. `seed` of the noise.
    explicit SignalFault(const Fault& fault, std::uint64_t seed = 1U);

    // The sample as the faulty sensor reports it. `active`: whether the fault is there in this cycle.
    SensorSample apply(const SensorSample& sample, bool active);

    // Whether the last sample's error was large enough to be seen. Frozen by chance at the right value is no
    // error.
    bool is_visible() const { return visible_; }

 private:
    struct Failing {
        const SensorSignal* signal;
        std::optional<double> frozen{};
        double drifted{0.0};
    };

    void change(Failing& failing, SensorSample& sample);
    double faulty(Failing& failing, double value);

    Fault fault_;
    std::vector<Failing> failing_{};
    NoiseSource noise_;
    bool visible_{false};
};

}  // namespace sil
