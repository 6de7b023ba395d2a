// Manoeuvre: what the driver does, on which road, how fast and for how long.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "sil/world/vehicle/disturbance.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/road.hpp"
#include "sil/world/vehicle/speed_control.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

struct DriverCommand {
    double steering_wheel_angle_rad{0.0};  // > 0 turns left
    SpeedPolicy speed_policy{SpeedPolicy::held};
    double brake{0.0};        // 0 to 1; the throttle is released while braking
    double speed_share{1.0};  // of the run's speed, for a driver who gathers speed first
};

// Sees the vehicle and acts; may keep state, such as a steering reversal that has begun. One object a run.
class Driver {
 public:
    Driver() = default;
    Driver& operator=(const Driver&) = delete;
    virtual ~Driver() = default;

    // Called once a step with the truth of the step before.
    virtual DriverCommand command(const Truth& truth) = 0;

    // The same driver in the same state, for a run that is saved.
    virtual std::unique_ptr<Driver> copy() const = 0;

 protected:
    Driver(const Driver&) = default;
};

// Declared by `Kind`: its copy constructor copies all of it.
template <typename Kind>
class CopiedDriver : public Driver {
 public:
    std::unique_ptr<Driver> copy() const override {
        return std::make_unique<Kind>(static_cast<const Kind&>(*this));
    }
};

// The seed draws the heights of a rough road; another road has no use for it.
using MakeRoad = std::function<std::unique_ptr<Road>(std::uint64_t seed)>;

// Disturbance at the time and in the motion of a truth; nothing is kept from step to step.
using DisturbanceCourse = std::function<Disturbance(const Truth& truth)>;
// The seed draws when, where and how much.
using DrawDisturbances = std::function<DisturbanceCourse(const VehicleParameters&, std::uint64_t seed)>;

// Manoeuvres are written for a first turn to the left; ManoeuvreRun mirrors them.
struct Manoeuvre {
    std::string name{};
    std::string description{};  // one line
    double duration_s{0.0};
    double initial_speed_mps{0.0};
    double start_speed_share{1.0};  // of that, with which the run begins
    // How fast the vehicle slides to the left as the run begins, over its speed.
    double start_sideways_share{0.0};
    MakeRoad make_road{};
    std::function<std::unique_ptr<Driver>(const VehicleParameters&)> make_driver{};
    // The same driver with hands of another speed, in rad/s at the handwheel; empty: the manoeuvre has no
    // ramp of one rate.
    std::function<std::unique_ptr<Driver>(const VehicleParameters&, double handwheel_radps)>
        make_driver_at_rate{};
    // Whether make_driver asks for handwheel_angle_at_0_3_g_rad(), so that who drives many may find it ahead.
    bool asks_for_handwheel_angle{false};
    // The manoeuvre's changes to the vehicle, such as a roof load; empty: nothing.
    std::function<VehicleParameters(VehicleParameters)> adapt_vehicle{};
    DrawDisturbances draw_disturbances{};  // empty: none
    // Something is done to the vehicle that no data of it tell, such as a gust, a flat tyre or a kerb: how
    // accurate estimates are, and whether good sensors are doubted, is asked without.
    bool is_disturbed{false};
};

// A driver who acts by the clock alone: the command as a function of time in seconds.
std::function<std::unique_ptr<Driver>(const VehicleParameters&)> open_loop(
    std::function<DriverCommand(double)> command);

// A driver whose hands have the given speed.
std::function<std::unique_ptr<Driver>(const VehicleParameters&)> at_rate(
    std::function<std::unique_ptr<Driver>(const VehicleParameters&, double handwheel_radps)> make_driver,
    double handwheel_radps);

// A level road.
MakeRoad flat_road();

constexpr double from_degrees(double degrees) {
    return degrees * 3.14159265358979323846 / 180.0;
}
constexpr double from_kmh(double kilometres_per_hour) {
    return kilometres_per_hour / 3.6;
}

constexpr double from_mph(double miles_per_hour) {
    return miles_per_hour * 0.44704;
}

// Turns to `angle` at `rate` from `start` on, and holds.
double ramp_and_hold(double time_s, double start_s, double rate_radps, double angle_rad);

}  // namespace sil
