// Sensor signal: one value of a sensor sample, where it is on the bus, and from which error on it matters.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sil/studies/faults/fault.hpp"
#include "sil/world/sensors/sensor_sample.hpp"

namespace sil {

struct SensorSignal {
    FaultPlace place;
    double SensorSample::* value;
    std::uint32_t identifier;  // of its frame
    std::size_t first_byte;    // of the signal, which has two
    bool little_endian;
    std::uint16_t code_out_of_range;
    const char* unit;
    double unit_si;         // of `unit`, in the unit of SensorSample
    double smallest_error;  // in `unit`: a smaller one is not held to be visible
    double offset;          // in `unit`: of the matrix
    double drift_ps;        // in `unit` a second: of the matrix
    double noise;           // in `unit`, rms: of the matrix
    double own_noise;       // in `unit`, rms: of a good sensor
};

inline constexpr std::size_t sensor_signal_count = 8U;
extern const std::array<SensorSignal, sensor_signal_count> sensor_signals;

// Optional on the bus, and therefore in lists of its own.
extern const SensorSignal mass_signal;

// Null for a place that is not one signal.
const SensorSignal* find_signal(FaultPlace place);

// Those that fail together at that place; of one signal that one, of none none.
std::vector<const SensorSignal*> signals_at(FaultPlace place);

}  // namespace sil
