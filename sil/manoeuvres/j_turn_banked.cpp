// J-turn on a banked circular road: rollover (the paper's Figs 11 and 12). The driver gathers speed in the
// curve, follows it at 110 km/h, then turns in to 200 degrees and lifts the foot.
#include <algorithm>
#include <cmath>
#include <optional>

#include "sil/manoeuvres/manoeuvre.hpp"
#include "sil/manoeuvres/path_follower.hpp"
#include "sil/manoeuvres/slowly_increasing_steer.hpp"

namespace sil {
namespace {

constexpr double radius_m = 500.0 * 0.3048;
constexpr double slope = 0.08;
constexpr double cg_height_m = 1.1;
constexpr double start_s = 8.0;
constexpr double rate_radps = from_degrees(250.0);
constexpr double angle_rad = from_degrees(200.0);
constexpr double preview_s = 1.2;

class BankedJTurnDriver final : public Driver {
 public:
    explicit BankedJTurnDriver(const PathFollower& follower) : follower_{follower} {}

    DriverCommand command(const Truth& truth) override {
        if (truth.time_s < start_s) {
            curve_rad_ = follower_.handwheel_rad(truth, target(truth));
            return {curve_rad_};
        }
        const double turned = rate_radps * (truth.time_s - start_s);
        return {std::max(curve_rad_, std::min(angle_rad, curve_rad_ + turned)), SpeedPolicy::off_throttle};
    }

 private:
    // On the circle about (0, radius), ahead of the vehicle.
    PathPoint target(const Truth& truth) const {
        const double from_centre = std::atan2(truth.position_y_m - radius_m, truth.position_x_m);
        const double angle = from_centre + follower_.preview_m(truth) / radius_m;
        return {radius_m * std::cos(angle), radius_m * (1.0 + std::sin(angle))};
    }

    PathFollower follower_;
    double curve_rad_{0.0};
};

// The body is raised; roof, floor and IMU rise with it.
VehicleParameters with_high_cg(VehicleParameters parameters) {
    parameters.geometry.cg_height_m = cg_height_m;
    return parameters;
}

}  // namespace

Manoeuvre j_turn_banked() {
    Manoeuvre manoeuvre;
    manoeuvre.name = "j-turn-banked";
    manoeuvre.description =
        "J-turn at 110 km/h out of a curve of 500 ft radius with 8 % bank, to 200 degrees, CG at 1.1 m";
    manoeuvre.duration_s = 13.0;
    manoeuvre.initial_speed_mps = from_kmh(110.0);
    manoeuvre.start_speed_factor = 0.6;
    manoeuvre.make_road = [] { return std::make_unique<BankedCircleRoad>(radius_m, std::atan(slope)); };
    manoeuvre.make_driver = [](const VehicleParameters& parameters) {
        const double gradient =
            understeer_gradient_s2pm(parameters, handwheel_angle_at_0_3_g_rad(parameters));
        return std::make_unique<BankedJTurnDriver>(PathFollower{parameters, gradient, preview_s});
    };
    manoeuvre.adapt_vehicle = with_high_cg;
    return manoeuvre;
}

}  // namespace sil
