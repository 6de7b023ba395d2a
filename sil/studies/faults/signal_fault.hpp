// Signal fault: a sensor whose value is wrong; its frame is protected as ever.
#pragma once

#include <optional>

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
    double faulty(double value);

    Fault fault_;
    const SensorSignal* signal_;
    NoiseSource noise_;
    std::optional<double> frozen_{};
    double drifted_{0.0};
    bool visible_{false};
};

}  // namespace sil
