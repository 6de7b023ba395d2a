// Path driver: follows a course that is laid out ahead, and releases the throttle at a place of it.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "sil/world/manoeuvres/manoeuvre.hpp"
#include "sil/world/manoeuvres/path_follower.hpp"

namespace sil {

// A line from the origin on, at first along the x axis.
class Course {
 public:
    static constexpr double spacing_m = 0.5;

    Course() : points_{PathPoint{}} {}

    // Goes on for `length_m` while the curvature (> 0 to the left) changes evenly from one value to the
    // other.
    Course& bend(double length_m, double from_curvature_pm, double to_curvature_pm);
    Course& straight(double length_m) { return bend(length_m, 0.0, 0.0); }
    // Changes lanes to the left by `aside_m` (below 0: to the right) over `length_m`, from and to the heading
    // of the x axis, with neither slope nor curvature at its ends.
    Course& change_lane(double length_m, double aside_m);

    // About `spacing_m` apart.
    const std::vector<PathPoint>& points() const { return points_; }

 private:
    std::vector<PathPoint> points_;
    double heading_rad_{0.0};
};

// A course of at least two points. The driver looks `preview_s` ahead, turns the handwheel no faster than in
// a fishhook and knows the vehicle's understeer: the manoeuvre asks for the handwheel angle. From
// `throttle_released_at_m` along the course on the foot is off the throttle. Beyond the end of the course the
// driver steers for its last point.
std::function<std::unique_ptr<Driver>(const VehicleParameters&)> path_driving(const Course& course,
                                                                              double preview_s,
                                                                              double throttle_released_at_m);

}  // namespace sil
