// Turns whose severity is that of the lateral acceleration which they would give if the vehicle were linear:
// step steer, turn on a rough road, braking in a turn.
#include "sil/world/manoeuvres/turn.hpp"

#include <algorithm>
#include <cmath>

#include "sil/units.hpp"
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"
#include "sil/world/vehicle/uneven_road.hpp"

namespace sil {
namespace {

constexpr double first_turn_s = 2.0;

double turn_angle_rad(const VehicleParameters& parameters, double acceleration_mps2) {
    return handwheel_angle_at_0_3_g_rad(parameters) * acceleration_mps2 / (0.3 * gravity_mps2);
}

}  // namespace

Manoeuvre turn(double acceleration_mps2, std::function<DriverCommand(double)> command) {
    Manoeuvre manoeuvre;
    manoeuvre.initial_speed_mps = from_mph(50.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.asks_for_handwheel_angle = true;
    manoeuvre.make_driver = [acceleration_mps2, command](const VehicleParameters& parameters) {
        const double angle_rad = turn_angle_rad(parameters, acceleration_mps2);
        return open_loop([angle_rad, command](double time_s) {
            DriverCommand scaled = command(time_s);
            scaled.steering_wheel_angle_rad *= angle_rad;
            return scaled;
        })(parameters);
    };
    return manoeuvre;
}

Manoeuvre held_turn(double acceleration_mps2, double start_s, double rate_ps) {
    return turn(acceleration_mps2, [start_s, rate_ps](double time_s) {
        return DriverCommand{ramp_and_hold(time_s, start_s, rate_ps, 1.0)};
    });
}

Manoeuvre swings(double acceleration_mps2) {
    constexpr double period_s = 2.5;
    return turn(acceleration_mps2, [](double time_s) {
        const double since_s = std::clamp(time_s - first_turn_s, 0.0, 1.5 * period_s);
        return DriverCommand{std::sin(2.0 * pi * since_s / period_s)};
    });
}

// ISO 7401 asks for 4 m/s^2; both sides, and back to straight between them.
Manoeuvre step_steer() {
    constexpr double step_s = 0.15;  // 200 to 500 degrees/s with what this takes
    constexpr double held_s = 3.0;
    const auto part = [](double time_s, double rate) {
        return ramp_and_hold(time_s, first_turn_s, rate, 1.0) -
               ramp_and_hold(time_s, first_turn_s + held_s, rate, 1.0) -
               ramp_and_hold(time_s, first_turn_s + 2.0 * held_s, rate, 1.0) +
               ramp_and_hold(time_s, first_turn_s + 3.0 * held_s, rate, 1.0);
    };
    constexpr double acceleration_mps2 = 4.0;
    Manoeuvre manoeuvre =
        turn(acceleration_mps2, [part](double time_s) { return DriverCommand{part(time_s, 1.0 / step_s)}; });
    manoeuvre.make_driver_at_rate = [part](const VehicleParameters& parameters, double rate_radps) {
        const double angle_rad = turn_angle_rad(parameters, acceleration_mps2);
        return open_loop([part, angle_rad, rate_radps](double time_s) {
            return DriverCommand{angle_rad * part(time_s, rate_radps / angle_rad)};
        })(parameters);
    };
    manoeuvre.name = "step-steer";
    manoeuvre.description =
        "step steer at 50 mph, held, to about 0.4 g left, straight, right, straight: no wheel lifts (ISO "
        "7401)";
    manoeuvre.duration_s = first_turn_s + 4.0 * held_s;
    return manoeuvre;
}

Manoeuvre rough_turn() {
    Manoeuvre manoeuvre = held_turn(3.0, first_turn_s, 1.0);
    manoeuvre.name = "rough-turn";
    manoeuvre.description = "turn of about 0.3 g at 50 mph, held, on a rough plane (ISO 8608 class C)";
    manoeuvre.duration_s = 20.0;
    manoeuvre.make_road = [](std::uint64_t seed) {
        return std::make_unique<RoughPlane>(RoughnessProfile::class_c_m3, seed);
    };
    return manoeuvre;
}

// After ISO 7975, whose turn has 5 m/s^2: the brakes come on while the handwheel stays.
Manoeuvre braking_in_turn() {
    constexpr double brake_s = 7.0;
    constexpr double brake_rate_ps = 5.0;
    constexpr double brake = 0.5;
    Manoeuvre manoeuvre = turn(5.0, [](double time_s) {
        DriverCommand command{ramp_and_hold(time_s, first_turn_s, 0.7, 1.0)};
        command.brake = ramp_and_hold(time_s, brake_s, brake_rate_ps, brake);
        return command;
    });
    manoeuvre.name = "braking-in-turn";
    manoeuvre.description =
        "turn of about 0.5 g at 50 mph, then half of full braking with the handwheel held (ISO 7975)";
    manoeuvre.duration_s = 12.0;
    return manoeuvre;
}

}  // namespace sil
