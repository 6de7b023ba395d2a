// Slowly increasing steer after NHTSA's rollover resistance test: 13.5 degrees per second to 270 degrees at
// 50 mph, held for two seconds.
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"

#include <stdexcept>

#include "sil/world/manoeuvres/manoeuvre.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"

namespace sil {
namespace {

constexpr double straight_s = 1.0;
constexpr double rate_radps = from_degrees(13.5);
constexpr double largest_angle_rad = from_degrees(270.0);
constexpr double held_s = 2.0;
constexpr double coarse_step_s = 0.002;  // twice the nominal one moves the angle by 0.05 %
constexpr double fit_from_mps2 = 0.1 * gravity_mps2;
constexpr double fit_to_mps2 = 0.375 * gravity_mps2;
constexpr double read_at_mps2 = 0.3 * gravity_mps2;

// Least squares for the line of handwheel angle over acceleration.
class Line {
 public:
    void add(double x, double y) {
        count_ += 1.0;
        x_ += x;
        y_ += y;
        xx_ += x * x;
        xy_ += x * y;
    }
    double at(double x) const {
        const double slope = (count_ * xy_ - x_ * y_) / (count_ * xx_ - x_ * x_);
        return y_ / count_ + slope * (x - x_ / count_);
    }

 private:
    double count_{0.0};
    double x_{0.0};
    double y_{0.0};
    double xx_{0.0};
    double xy_{0.0};
};

Manoeuvre steer_from(double start_s) {
    Manoeuvre manoeuvre;
    manoeuvre.initial_speed_mps = from_mph(50.0);
    manoeuvre.duration_s = start_s + largest_angle_rad / rate_radps + held_s;
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = open_loop([start_s](double time_s) {
        return DriverCommand{ramp_and_hold(time_s, start_s, rate_radps, largest_angle_rad),
                             SpeedPolicy::held};
    });
    return manoeuvre;
}

}  // namespace

Manoeuvre slowly_increasing_steer();
Manoeuvre slowly_increasing_steer() {
    Manoeuvre manoeuvre = steer_from(straight_s);
    manoeuvre.name = "slowly-increasing-steer";
    manoeuvre.description = "NHTSA's slowly increasing steer: 50 mph, held, 13.5 degrees/s up to 270 degrees";
    return manoeuvre;
}

double handwheel_angle_at_0_3_g_rad(const VehicleParameters& parameters, bool mirrored) {
    RunOptions options;
    options.step_s = coarse_step_s;
    options.mirrored = mirrored;
    const double direction = mirrored ? -1.0 : 1.0;
    ManoeuvreRun run{parameters, steer_from(0.0), options};
    Line line;
    while (!run.finished()) {
        run.step();
        const double acceleration = direction * run.truth().lateral_acceleration_mps2;
        if (acceleration > fit_to_mps2) {
            return line.at(read_at_mps2);
        }
        if (acceleration > fit_from_mps2) {
            line.add(acceleration, direction * run.truth().steering_wheel_angle_rad);
        }
    }
    throw std::runtime_error(
        "The vehicle '" + parameters.name +
        "' does not reach 0.375 g in a slowly increasing steer at 50 mph, so the manoeuvre's handwheel "
        "angle cannot be found. Look at its steering ratio and its tyres' friction.");
}

}  // namespace sil
