// Slow ramp steer: quasi-static, to one side and then the other, up to where the inner wheels grow light;
// what the roll stiffness and the roll-centre height are identified from.
#include "sil/world/manoeuvres/slow_ramp.hpp"

#include <algorithm>
#include <cmath>

namespace sil {
namespace {

constexpr double start_s = 1.0;
constexpr double rate_radps = from_degrees(3.0);
constexpr double largest_angle_rad = from_degrees(150.0);
constexpr double back_rate_radps = from_degrees(45.0);
constexpr double straight_s = 2.0;
constexpr double never_s = 1.0e9;

double load_transfer_ratio(const Truth& truth) {
    const auto& load = truth.wheel_load_n;
    const double left = load[front_left] + load[rear_left];
    const double right = load[front_right] + load[rear_right];
    return (right - left) / std::max(1.0, left + right);
}

class SlowRampDriver final : public CopiedDriver<SlowRampDriver> {
 public:
    explicit SlowRampDriver(double back_from_ltr) : back_from_ltr_{back_from_ltr} {}

    DriverCommand command(const Truth& truth) override {
        const double step_s = truth.time_s - last_time_s_;
        last_time_s_ = truth.time_s;
        if (truth.time_s >= next_ramp_s_) {
            advance(truth, step_s);
        }
        return {side_ * angle_rad_};
    }

 private:
    void advance(const Truth& truth, double step_s) {
        if (!turning_back_) {
            angle_rad_ += rate_radps * step_s;
            turning_back_ =
                angle_rad_ >= largest_angle_rad || std::abs(load_transfer_ratio(truth)) >= back_from_ltr_;
            return;
        }
        angle_rad_ = std::max(0.0, angle_rad_ - back_rate_radps * step_s);
        if (angle_rad_ <= 0.0) {
            turning_back_ = false;
            next_ramp_s_ = side_ > 0.0 ? truth.time_s + straight_s : never_s;
            side_ = -1.0;
        }
    }

    double back_from_ltr_;
    double last_time_s_{0.0};
    double next_ramp_s_{start_s};
    double angle_rad_{0.0};
    double side_{1.0};
    bool turning_back_{false};
};

}  // namespace

Manoeuvre slow_ramp(double back_from_ltr) {
    Manoeuvre manoeuvre;
    manoeuvre.name = "slow-ramp";
    manoeuvre.description =
        "slow ramp steer at 60 km/h, held: 3 degrees/s to either side until the inner wheels are light";
    manoeuvre.duration_s = 115.0;
    manoeuvre.initial_speed_mps = from_kmh(60.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = [back_from_ltr](const VehicleParameters&) {
        return std::make_unique<SlowRampDriver>(back_from_ltr);
    };
    return manoeuvre;
}

}  // namespace sil
