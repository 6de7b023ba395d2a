// Scene: what the sensors report in a drive without faults, and when a fault begins and ends in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sil/sensors/sensor_sample.hpp"
#include "sil/vehicle/parameters.hpp"

namespace sil {

// In the order of the matrix.
enum class SceneKind : std::uint8_t { rest, straight, turn, before_turn, warning };
inline constexpr std::size_t scene_count = 5U;

// The ECU only warns, so no answer of its changes the drive: one recording serves every fault.
struct Scene {
    SceneKind kind{};
    std::string name{};
    std::string description{};
    std::vector<SensorSample> samples{};  // one a cycle
    std::size_t fault_begin{0U};          // cycle
    std::size_t fault_end{0U};  // cycle after the last one; samples.size() when the scene ends first
};

// At rest, straight ahead, in a turn, before a turn that leads to a warning, in the moment of warning. The
// sensors have noise.
std::vector<Scene> record_scenes(const VehicleParameters& vehicle);

// In the scene `warning` the fault begins so long before the ECU would warn.
inline constexpr double before_warning_s = 0.1;

}  // namespace sil
