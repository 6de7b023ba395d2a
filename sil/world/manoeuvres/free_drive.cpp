#include "sil/world/manoeuvres/free_drive.hpp"

#include <algorithm>
#include <cmath>

namespace sil {
namespace {

// A brisk pull away, a firm brake pedal: who chooses another speed does not get it at once.
constexpr double speed_change_mps2 = 3.0;

double towards(double from, double wanted, double most_change) {
    return std::isfinite(wanted) ? std::clamp(wanted, from - most_change, from + most_change) : from;
}

class FreeDriver final : public CopiedDriver<FreeDriver> {
 public:
    FreeDriver(const DriverWish& wish, double start_speed_mps)
        : wish_{wish}, start_speed_mps_{start_speed_mps}, speed_mps_{start_speed_mps} {}

    DriverCommand command(const Truth& truth) override {
        const double since_s = truth.time_s - last_s_;
        last_s_ = truth.time_s;
        angle_rad_ = towards(angle_rad_, wish_.steering_wheel_angle_rad, fastest_hands_radps * since_s);
        angle_rad_ = std::clamp(angle_rad_, -DriverWish::largest_angle_rad, DriverWish::largest_angle_rad);
        speed_mps_ = towards(speed_mps_, wish_.speed_mps, speed_change_mps2 * since_s);
        speed_mps_ = std::clamp(speed_mps_, DriverWish::lowest_speed_mps, DriverWish::highest_speed_mps);
        DriverCommand command;
        command.steering_wheel_angle_rad = angle_rad_;
        command.speed_share = speed_mps_ / start_speed_mps_;
        return command;
    }

 private:
    const DriverWish& wish_;
    double start_speed_mps_;
    double speed_mps_;
    double angle_rad_{0.0};
    double last_s_{0.0};
};

}  // namespace

Manoeuvre free_drive(const DriverWish& wish, double start_speed_mps) {
    const double start_mps =
        std::clamp(start_speed_mps, DriverWish::lowest_speed_mps, DriverWish::highest_speed_mps);
    Manoeuvre manoeuvre;
    manoeuvre.name = "free-drive";
    manoeuvre.description = "driven by a person, on a level road";
    manoeuvre.duration_s = longest_free_drive_s;
    manoeuvre.initial_speed_mps = start_mps;
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = [&wish, start_mps](const VehicleParameters&) {
        return std::make_unique<FreeDriver>(wish, start_mps);
    };
    return manoeuvre;
}

}  // namespace sil
