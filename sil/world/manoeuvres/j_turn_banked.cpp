// J-turn on a banked circular road: rollover (the paper's Figs 11 and 12). The driver gathers speed in the
// curve, follows it at 110 km/h, then turns in to 200 degrees and lifts the foot.
#include <algorithm>
#include <cmath>
#include <optional>

#include "sil/world/manoeuvres/manoeuvre.hpp"
#include "sil/world/manoeuvres/path_follower.hpp"
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"

namespace sil {
namespace {

constexpr double radius_m = 500.0 * 0.3048;
constexpr double slope = 0.08;
constexpr double cg_rise_m = 1.1 - 0.988;  // the paper's; for any vehicle
constexpr double start_s = 12.0;
constexpr double start_share = 0.75;  // of the speed; it is reached gently, two seconds before the turn
constexpr double gathering_s = 10.0;
constexpr double turning_in_s = 1.0;  // into the curve, at the very beginning
constexpr double rate_radps = from_degrees(250.0);
constexpr double angle_rad = from_degrees(200.0);
constexpr double preview_s = 1.2;

class BankedJTurnDriver final : public CopiedDriver<BankedJTurnDriver> {
 public:
    explicit BankedJTurnDriver(const PathFollower& follower) : follower_{follower} {}

    DriverCommand command(const Truth& truth) override {
        if (truth.time_s < start_s) {
            const double turned_in = std::min(1.0, truth.time_s / turning_in_s);
            curve_rad_ = turned_in * follower_.handwheel_rad(truth, target(truth));
            const double gathered = std::min(1.0, truth.time_s / gathering_s);
            DriverCommand command{curve_rad_};
            command.speed_share = start_share + (1.0 - start_share) * gathered;
            return command;
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
    parameters.geometry.cg_height_m += cg_rise_m;
    return parameters;
}

}  // namespace

Manoeuvre j_turn_banked() {
    Manoeuvre manoeuvre;
    manoeuvre.name = "j-turn-banked";
    manoeuvre.description =
        "J-turn at 110 km/h out of a curve of 500 ft radius with 8 % bank, to 200 degrees, CG raised by 112 "
        "mm";
    manoeuvre.duration_s = 17.0;
    manoeuvre.initial_speed_mps = from_kmh(110.0);
    manoeuvre.start_speed_share = start_share;
    manoeuvre.make_road = [](std::uint64_t) {
        return std::make_unique<BankedCircleRoad>(radius_m, std::atan(slope));
    };
    manoeuvre.asks_for_handwheel_angle = true;
    manoeuvre.make_driver = [](const VehicleParameters& parameters) {
        const double gradient =
            understeer_gradient_s2pm(parameters, handwheel_angle_at_0_3_g_rad(parameters));
        return std::make_unique<BankedJTurnDriver>(PathFollower{parameters, gradient, preview_s});
    };
    manoeuvre.adapt_vehicle = with_high_cg;
    return manoeuvre;
}

}  // namespace sil
