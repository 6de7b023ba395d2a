// Double lane change on the track of ISO 3888-2; the throttle is released 2 m after the entry.
#include <algorithm>
#include <cmath>

#include "sil/world/manoeuvres/manoeuvre.hpp"
#include "sil/world/manoeuvres/path_follower.hpp"
#include "sil/world/manoeuvres/rule_book.hpp"
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"

namespace sil {
namespace {

constexpr double entry_m = 40.0;
constexpr double throttle_released_after_m = 2.0;
constexpr double preview_s = 0.5;
constexpr double entry_speed_kmh = 55.0;  // each of the three vehicles still keeps the track

// The line that the driver wants: in section 1 a little to the right, then close by the cones that he must
// pass; a change of lane begins before the section ends and ends after the next one has begun.
constexpr double first_lane_m = -0.08;
constexpr double room_to_side_lane_cones_m = 0.42;
constexpr double room_to_last_cones_m = 0.45;
constexpr double leaving_first_m = 5.0;
constexpr double leaving_side_m = 6.0;
constexpr double entering_m = 6.0;

// A change of lane from 0 to 1 with neither slope nor curvature at its ends.
double change(double x, double from, double to) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * t * (10.0 + t * (-15.0 + 6.0 * t));
}

class LaneChangeDriver final : public CopiedDriver<LaneChangeDriver> {
 public:
    LaneChangeDriver(const PathFollower& follower, double vehicle_width_m)
        : follower_{follower},
          track_{lane_change_track(entry_m, vehicle_width_m)},
          side_lane_m_{track_[1].right_m + 0.5 * vehicle_width_m + room_to_side_lane_cones_m},
          last_lane_m_{track_[2].left_m - 0.5 * vehicle_width_m - room_to_last_cones_m} {}

    DriverCommand command(const Truth& truth) override {
        const double ahead = truth.position_x_m + follower_.preview_m(truth);
        const bool released = truth.position_x_m >= entry_m + throttle_released_after_m;
        return {follower_.handwheel_rad(truth, {ahead, path_m(ahead)}),
                released ? SpeedPolicy::off_throttle : SpeedPolicy::held};
    }

 private:
    double path_m(double x) const {
        const double out = change(x, track_[0].end_m - leaving_first_m, track_[1].begin_m + entering_m);
        const double back = change(x, track_[1].end_m - leaving_side_m, track_[2].begin_m + entering_m);
        return first_lane_m + (side_lane_m_ - first_lane_m) * out + (last_lane_m_ - side_lane_m_) * back;
    }

    PathFollower follower_;
    std::array<LaneSection, 3> track_;
    double side_lane_m_;
    double last_lane_m_;
};

}  // namespace

std::array<LaneSection, 3> lane_change_track(double begin_m, double vehicle_width_m) {
    const double first = 1.1 * vehicle_width_m + 0.25;
    const double side = vehicle_width_m + 1.0;
    const double last = std::max(3.0, 1.3 * vehicle_width_m + 0.25);
    const double side_right = 0.5 * first + 1.0;
    const double third_begin = begin_m + 12.0 + 13.5;
    const double fifth_begin = third_begin + 11.0 + 12.5;
    return {{{begin_m, begin_m + 12.0, -0.5 * first, 0.5 * first},
             {third_begin, third_begin + 11.0, side_right, side_right + side},
             {fifth_begin, fifth_begin + 12.0, -0.5 * last, 0.5 * last}}};
}

Manoeuvre double_lane_change() {
    Manoeuvre manoeuvre;
    manoeuvre.name = "double-lane-change";
    manoeuvre.description =
        "double lane change on the track of ISO 3888-2, entered at 55 km/h, throttle released";
    manoeuvre.duration_s = 11.0;
    manoeuvre.initial_speed_mps = from_kmh(entry_speed_kmh);
    manoeuvre.make_road = flat_road();
    manoeuvre.asks_for_handwheel_angle = true;
    manoeuvre.make_driver = [](const VehicleParameters& parameters) {
        const double gradient =
            understeer_gradient_s2pm(parameters, handwheel_angle_at_0_3_g_rad(parameters));
        return std::make_unique<LaneChangeDriver>(PathFollower{parameters, gradient, preview_s},
                                                  2.0 * parameters.hull.half_width_m);
    };
    return manoeuvre;
}

}  // namespace sil
