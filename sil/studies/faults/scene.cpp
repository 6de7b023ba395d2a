#include "sil/studies/faults/scene.hpp"

#include <algorithm>
#include <utility>

#include "sil/world/manoeuvres/catalogue.hpp"

namespace sil {
namespace {

RecordedDrive record(const VehicleParameters& vehicle, const Manoeuvre& manoeuvre) {
    return record_drive(vehicle, manoeuvre, {}, {recording_sensors(vehicle)}).front();
}

Scene scene(SceneKind kind, const char* name, const char* description, RecordedDrive drive, double begin_s,
            double end_s) {
    const std::size_t end = std::min(cycle_count(end_s), drive.samples.size());
    return {{std::move(drive), cycle_count(begin_s), end}, kind, name, description};
}

Scene at_warning(const Scene& drive, SceneKind kind, const char* name, const char* description,
                 std::size_t begin, std::size_t end) {
    Scene scene = drive;
    scene.kind = kind;
    scene.name = name;
    scene.description = description;
    scene.fault_begin = begin;
    scene.fault_end = end;
    return scene;
}

}  // namespace

std::vector<Scene> record_scenes(const VehicleParameters& vehicle) {
    constexpr double forever_s = 1.0e6;
    constexpr double straight_s = 4.0;
    constexpr double steering_s = straight_s + 1.0;  // as the J-turn's driver does
    Manoeuvre straight = find_manoeuvre("straight");
    straight.duration_s = 15.0;
    Manoeuvre turn = find_manoeuvre("rough-turn");
    return {
        scene(SceneKind::rest, "rest", "the vehicle stands; fault from 4 s to 8 s",
              record_rest(vehicle, 15.0, {recording_sensors(vehicle)}).front(), 4.0, 8.0),
        scene(SceneKind::straight, "straight", "straight ahead at 100 km/h; fault from 4 s to 8 s",
              record(vehicle, straight), 4.0, 8.0),
        scene(SceneKind::turn, "turn",
              "held turn of 0.3 g on a rough road at 80 km/h; fault from 6 s to 10 s", record(vehicle, turn),
              6.0, 10.0),
        scene(
            SceneKind::before_turn, "before the turn",
            "J-turn at 110 km/h that ends in a rollover; the fault begins 0.5 s before the driver steers and "
            "0.6 s before the warning is due (as he steers), and stays",
            record(vehicle, with_lead_in(find_manoeuvre("j-turn-110"), straight_s)), steering_s - 0.5,
            forever_s),
    };
}

std::vector<Scene> scenes_at_warning(const Scene& before_turn, std::size_t due) {
    constexpr const char* warning = "warning";
    constexpr const char* about_warning =
        "the same; the fault begins 0.3 s and 0.1 s before the warning is due, and stays";
    const std::size_t end = before_turn.samples.size();
    return {
        at_warning(before_turn, SceneKind::steering, before_turn.name.c_str(),
                   before_turn.description.c_str(), due - cycle_count(0.6), end),
        at_warning(before_turn, SceneKind::before_warning, warning, about_warning, due - cycle_count(0.3),
                   end),
        at_warning(before_turn, SceneKind::warning, warning, about_warning, due - cycle_count(0.1), end),
        at_warning(before_turn, SceneKind::over, "over before the warning",
                   "the same; the fault begins 1 s before the warning is due, and ends 0.2 s before it",
                   due - cycle_count(1.0), due - cycle_count(over_before_warning_ms * 1.0e-3)),
    };
}

}  // namespace sil
