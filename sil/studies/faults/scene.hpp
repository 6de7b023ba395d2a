// Scene: what the sensors report in a drive without faults, and when a fault begins and ends in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sil/studies/faults/recorded_drive.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// In the order of the matrix.
enum class SceneKind : std::uint8_t {
    rest,
    straight,
    turn,
    before_turn,     // that leads to a warning
    steering,        // as it begins
    before_warning,  //
    warning,         // in the moment of it
    over,            // just before it
};
inline constexpr std::size_t scene_count = 8U;

// Scenes of one name stand in one column of the matrix.
struct Scene : FaultedDrive {
    SceneKind kind{};
    std::string name{};
    std::string description{};
};

// At rest, straight ahead, in a turn, before a turn that leads to a warning. The sensors have noise.
std::vector<Scene> record_scenes(const VehicleParameters& vehicle);

// Scenes on the drive of `before_turn`, in which a warning is due in the cycle `due`: faults that begin at
// several times before it and stay, and one that is over just before it.
std::vector<Scene> scenes_at_warning(const Scene& before_turn, std::size_t due);

// Time before the due warning at which the fault of the scene `over` ends.
inline constexpr int over_before_warning_ms = 200;

}  // namespace sil
