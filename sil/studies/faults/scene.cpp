#include "sil/studies/faults/scene.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "sil/results/two_wheel_lift.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/sensors/sensor_suite.hpp"
#include "sil/world/simulation/mounted_sensors.hpp"
#include "sil/world/simulation/pace.hpp"

namespace sil {
namespace {

constexpr std::uint64_t noise_seed = 5U;
constexpr double rolled_over_rad = 1.2;
constexpr int steps_per_cycle = 10;

constexpr std::size_t cycles(double seconds) {
    return static_cast<std::size_t>(seconds / cycle_time_s + 0.5);
}

SensorSuite make_sensors(const VehicleParameters& vehicle) {
    SensorFlaws flaws;
    flaws.noise = true;
    flaws.seed = noise_seed;
    flaws.bank_sensor = true;
    return SensorSuite{mounted_sensors(vehicle, flaws)};
}

struct Recording {
    std::vector<SensorSample> samples{};
    std::optional<std::size_t> two_wheel_lift{};
};

Recording record(const VehicleParameters& vehicle, const Manoeuvre& manoeuvre) {
    ManoeuvreRun plant{vehicle, manoeuvre};
    SensorSuite sensors = make_sensors(vehicle);
    Recording recording;
    TwoWheelLiftObserver two_wheels;
    sensors.observe(plant.truth());
    for (;;) {
        const Truth& truth = plant.truth();
        two_wheels.observe({truth.time_s, truth.lateral_acceleration_mps2, truth.roll_angle_rad},
                           left_side_has_lifted(truth), right_side_has_lifted(truth));
        if (two_wheels.lift_off()) {
            recording.two_wheel_lift = cycles(two_wheels.lift_off()->moment.time_s);
        }
        recording.samples.push_back(sensors.report(plant.truth()));
        if (plant.finished() || std::abs(plant.truth().roll_angle_rad) > rolled_over_rad) {
            return recording;
        }
        for (int step = 0; step < steps_per_cycle; ++step) {
            plant.step();
            sensors.observe(plant.truth());
        }
    }
}

// The tyre model wants a rolling wheel, so a vehicle at rest is written down instead of driven.
Recording record_rest(const VehicleParameters& vehicle, double duration_s) {
    Truth truth;
    truth.specific_force_mps2 = {0.0, 0.0, g_mps2};
    SensorSuite sensors = make_sensors(vehicle);
    Recording recording;
    for (std::size_t cycle = 0U; cycle <= cycles(duration_s); ++cycle) {
        truth.time_s = static_cast<double>(cycle) * cycle_time_s;
        sensors.observe(truth);
        recording.samples.push_back(sensors.report(truth));
    }
    return recording;
}

// The driver of a manoeuvre after some seconds of straight road.
class LateDriver final : public Driver {
 public:
    LateDriver(std::unique_ptr<Driver> driver, double delay_s)
        : driver_{std::move(driver)}, delay_s_{delay_s} {}

    DriverCommand command(const Truth& truth) override {
        if (truth.time_s < delay_s_) {
            return {};
        }
        Truth late = truth;
        late.time_s -= delay_s_;
        return driver_->command(late);
    }

 private:
    std::unique_ptr<Driver> driver_;
    double delay_s_;
};

Manoeuvre delayed(Manoeuvre manoeuvre, double delay_s) {
    manoeuvre.duration_s += delay_s;
    manoeuvre.make_driver = [inner = manoeuvre.make_driver, delay_s](const VehicleParameters& parameters) {
        return std::make_unique<LateDriver>(inner(parameters), delay_s);
    };
    return manoeuvre;
}

Scene scene(SceneKind kind, std::string name, std::string description, Recording recording, double begin_s,
            double end_s) {
    const std::size_t end = std::min(cycles(end_s), recording.samples.size());
    return {
        kind, std::move(name),         std::move(description), std::move(recording.samples), cycles(begin_s),
        end,  recording.two_wheel_lift};
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
              record_rest(vehicle, 15.0), 4.0, 8.0),
        scene(SceneKind::straight, "straight", "straight ahead at 100 km/h; fault from 4 s to 8 s",
              record(vehicle, straight), 4.0, 8.0),
        scene(SceneKind::turn, "turn",
              "held turn of 0.3 g on a rough road at 80 km/h; fault from 6 s to 10 s", record(vehicle, turn),
              6.0, 10.0),
        scene(
            SceneKind::before_turn, "before the turn",
            "J-turn at 110 km/h that ends in a rollover; the fault begins 0.5 s before the driver steers and "
            "0.6 s before the warning is due (as he steers), and stays",
            record(vehicle, delayed(find_manoeuvre("j-turn-110"), straight_s)), steering_s - 0.5, forever_s),
    };
}

std::vector<Scene> scenes_at_warning(const Scene& before_turn, std::size_t due) {
    constexpr const char* warning = "warning";
    constexpr const char* about_warning =
        "the same; the fault begins 0.3 s and 0.1 s before the warning is due, and stays";
    const std::size_t end = before_turn.samples.size();
    return {
        at_warning(before_turn, SceneKind::steering, before_turn.name.c_str(),
                   before_turn.description.c_str(), due - cycles(0.6), end),
        at_warning(before_turn, SceneKind::before_warning, warning, about_warning, due - cycles(0.3), end),
        at_warning(before_turn, SceneKind::warning, warning, about_warning, due - cycles(0.1), end),
        at_warning(before_turn, SceneKind::over, "over before the warning",
                   "the same; the fault begins 1 s before the warning is due, and ends 0.2 s before it",
                   due - cycles(1.0), due - cycles(over_before_warning_ms * 1.0e-3)),
    };
}

}  // namespace sil
