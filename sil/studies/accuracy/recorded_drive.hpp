// Recorded drive: a manoeuvre's truth, kept so that many sensors and many calibrations can be tried on it.
#pragma once

#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/world/sensors/sensor_options.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil::accuracy {

struct RecordedDrive {
    std::string manoeuvre{};
    std::string vehicle{};
    sil::VehicleParameters vehicle_parameters{};
    std::vector<sil::Truth> truths{};  // every millisecond
};

// The vehicle is one of sil/vehicles, by its file's name. Ends when the vehicle lies on its side.
RecordedDrive record(const std::string& manoeuvre, const std::string& vehicle, bool mirrored = false);

struct SensorQuality {
    bool noise{true};
    double lateral_bias_g{0.0};
    double vertical_bias_g{0.0};
    std::uint64_t seed{1U};
};

struct Cycle {
    const sil::Truth* truth;
    rsi::Outputs outputs;
};

// The component over the drive, one entry a cycle of 10 ms. Without the bus, whose resolution is finer than
// the noise.
std::vector<Cycle> evaluate(const RecordedDrive& drive, const SensorQuality& quality,
                            const rsi::Parameters& parameters);

rsi::Parameters calibration(const std::string& vehicle);

}  // namespace sil::accuracy
