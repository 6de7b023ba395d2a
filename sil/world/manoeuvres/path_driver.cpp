#include "sil/world/manoeuvres/path_driver.hpp"

#include <algorithm>
#include <cmath>

#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"

namespace sil {
namespace {

using Points = std::shared_ptr<const std::vector<PathPoint>>;

constexpr double fastest_hands_radps = from_degrees(720.0);  // as in the fishhook

class PathDriver final : public CopiedDriver<PathDriver> {
 public:
    PathDriver(const PathFollower& follower, Points points, double throttle_released_at_m)
        : follower_{follower}, points_{std::move(points)}, throttle_released_at_m_{throttle_released_at_m} {}

    DriverCommand command(const Truth& truth) override {
        while (nearest_ + 1U < points_->size() &&
               distance(truth, nearest_ + 1U) < distance(truth, nearest_)) {
            ++nearest_;
        }
        const double along_m = along(truth);
        const double wanted = follower_.handwheel_rad(truth, point_at(along_m + follower_.preview_m(truth)));
        const double most = fastest_hands_radps * (truth.time_s - last_s_);
        last_s_ = truth.time_s;
        handwheel_rad_ = std::clamp(wanted, handwheel_rad_ - most, handwheel_rad_ + most);
        return {handwheel_rad_,
                along_m >= throttle_released_at_m_ ? SpeedPolicy::off_throttle : SpeedPolicy::held};
    }

 private:
    double distance(const Truth& truth, std::size_t point) const {
        return std::hypot((*points_)[point].x_m - truth.position_x_m,
                          (*points_)[point].y_m - truth.position_y_m);
    }

    // Way along the course to the foot of the vehicle's perpendicular on it.
    double along(const Truth& truth) const {
        const PathPoint& before = (*points_)[nearest_ > 0U ? nearest_ - 1U : 0U];
        const PathPoint& after = (*points_)[std::min(nearest_ + 1U, points_->size() - 1U)];
        const double way = std::hypot(after.x_m - before.x_m, after.y_m - before.y_m);
        const PathPoint& nearest = (*points_)[nearest_];
        const double ahead = ((truth.position_x_m - nearest.x_m) * (after.x_m - before.x_m) +
                              (truth.position_y_m - nearest.y_m) * (after.y_m - before.y_m)) /
                             way;
        return Course::spacing_m * static_cast<double>(nearest_) +
               std::clamp(ahead, -Course::spacing_m, Course::spacing_m);
    }

    PathPoint point_at(double along_m) const {
        const double place =
            std::clamp(along_m / Course::spacing_m, 0.0, static_cast<double>(points_->size() - 1U));
        const auto before = std::min(static_cast<std::size_t>(place), points_->size() - 2U);
        const double share = place - static_cast<double>(before);
        const PathPoint& from = (*points_)[before];
        const PathPoint& to = (*points_)[before + 1U];
        return {from.x_m + share * (to.x_m - from.x_m), from.y_m + share * (to.y_m - from.y_m)};
    }

    PathFollower follower_;
    Points points_;
    double throttle_released_at_m_;
    std::size_t nearest_{0U};
    double handwheel_rad_{0.0};
    double last_s_{0.0};
};

}  // namespace

Course& Course::bend(double length_m, double from_curvature_pm, double to_curvature_pm) {
    const int steps = std::max(1, static_cast<int>(std::lround(length_m / spacing_m)));
    for (int step = 0; step < steps; ++step) {
        const double done = (step + 0.5) / steps;
        const double turned = spacing_m * (from_curvature_pm + done * (to_curvature_pm - from_curvature_pm));
        const double middle = heading_rad_ + 0.5 * turned;
        heading_rad_ += turned;
        points_.push_back({points_.back().x_m + spacing_m * std::cos(middle),
                           points_.back().y_m + spacing_m * std::sin(middle)});
    }
    return *this;
}

Course& Course::change_lane(double length_m, double aside_m) {
    const PathPoint from = points_.back();
    const int steps = std::max(1, static_cast<int>(std::lround(length_m / spacing_m)));
    for (int step = 1; step <= steps; ++step) {
        const double t = static_cast<double>(step) / steps;
        points_.push_back(
            {from.x_m + t * length_m, from.y_m + aside_m * t * t * t * (10.0 + t * (-15.0 + 6.0 * t))});
    }
    return *this;
}

std::function<std::unique_ptr<Driver>(const VehicleParameters&)> path_driving(const Course& course,
                                                                              double preview_s,
                                                                              double throttle_released_at_m) {
    auto points = std::make_shared<const std::vector<PathPoint>>(course.points());
    return [points, preview_s, throttle_released_at_m](const VehicleParameters& parameters) {
        const double gradient =
            understeer_gradient_s2pm(parameters, handwheel_angle_at_0_3_g_rad(parameters));
        return std::make_unique<PathDriver>(PathFollower{parameters, gradient, preview_s}, points,
                                            throttle_released_at_m);
    };
}

}  // namespace sil
