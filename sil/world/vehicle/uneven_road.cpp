// Uneven roads: heights and their slopes.
#include "sil/world/vehicle/uneven_road.hpp"

#include <algorithm>
#include <cmath>

#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double level_until_m = 20.0;
constexpr double complete_from_m = 40.0;
constexpr double half_joint_m = 0.5;  // of the surface between the tracks
constexpr int corrugation_count = 5;

struct Blend {
    double value{0.0};
    double slope{0.0};
};

// From 0 at `from` to 1 at `to`, level at both.
Blend smooth_step(double x, double from, double to) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return {t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / (to - from)};
}

RoadPoint surface(double height_m, double slope_x, double slope_y) {
    RoadPoint point;
    point.height_m = height_m;
    point.normal = Vector3{-slope_x, -slope_y, 1.0} / std::sqrt(1.0 + slope_x * slope_x + slope_y * slope_y);
    return point;
}

}  // namespace

TwoTrackRoad::TwoTrackRoad(double density_m3, std::uint64_t seed)
    : left_{density_m3, 2U * seed}, right_{density_m3, 2U * seed + 1U} {}

RoadPoint TwoTrackRoad::at(double x_m, double y_m) const noexcept {
    const Blend run_in = smooth_step(x_m, level_until_m, complete_from_m);
    if (run_in.value <= 0.0) {
        return {};
    }
    const Blend side = smooth_step(y_m, -half_joint_m, half_joint_m);
    const ProfilePoint left = side.value > 0.0 ? left_.at(x_m) : ProfilePoint{};
    const ProfilePoint right = side.value < 1.0 ? right_.at(x_m) : ProfilePoint{};
    const double height = right.height_m + side.value * (left.height_m - right.height_m);
    const double along = right.slope + side.value * (left.slope - right.slope);
    return surface(run_in.value * height, run_in.value * along + run_in.slope * height,
                   run_in.value * side.slope * (left.height_m - right.height_m));
}

RoughPlane::RoughPlane(double density_m3, std::uint64_t seed) {
    // A corrugation seen at an angle is drawn out, which scales its density by the cosine; the mean of that
    // over all angles is 2 / pi.
    const double each = density_m3 * pi / (2.0 * corrugation_count);
    corrugations_.reserve(corrugation_count);
    for (int i = 0; i < corrugation_count; ++i) {
        // Between the axes, so that left and right of a track along x differ.
        const double direction = pi * (i + 0.5) / corrugation_count;
        corrugations_.push_back(
            {std::cos(direction), std::sin(direction),
             RoughnessProfile{each, seed * corrugation_count + static_cast<std::uint64_t>(i)}});
    }
}

RoadPoint RoughPlane::at(double x_m, double y_m) const noexcept {
    const double distance = std::sqrt(x_m * x_m + y_m * y_m);
    const Blend run_in = smooth_step(distance, level_until_m, complete_from_m);
    if (run_in.value <= 0.0) {
        return {};
    }
    double height = 0.0;
    double slope_x = 0.0;
    double slope_y = 0.0;
    for (const Corrugation& corrugation : corrugations_) {
        const ProfilePoint point = corrugation.profile.at(x_m * corrugation.cosine + y_m * corrugation.sine);
        height += point.height_m;
        slope_x += point.slope * corrugation.cosine;
        slope_y += point.slope * corrugation.sine;
    }
    const double outwards = run_in.slope * height / distance;
    return surface(run_in.value * height, run_in.value * slope_x + outwards * x_m,
                   run_in.value * slope_y + outwards * y_m);
}

OneSidedBumpRoad::OneSidedBumpRoad(double height_m, double length_m, double first_m, double interval_m,
                                   int count)
    : height_m_{height_m},
      length_m_{length_m},
      first_m_{first_m},
      interval_m_{interval_m},
      count_{static_cast<double>(count)} {}

RoadPoint OneSidedBumpRoad::at(double x_m, double y_m) const noexcept {
    const double number = std::floor((x_m - first_m_) / interval_m_);
    const double along = x_m - first_m_ - number * interval_m_;
    if (y_m <= 0.0 || number < 0.0 || number >= count_ || along >= length_m_) {
        return {};
    }
    const double phase = 2.0 * pi * along / length_m_;
    const Blend side = smooth_step(y_m, 0.0, half_joint_m);
    const double height = 0.5 * height_m_ * (1.0 - std::cos(phase));
    return surface(side.value * height, side.value * height_m_ * pi / length_m_ * std::sin(phase),
                   side.slope * height);
}

BankedStretchRoad::BankedStretchRoad(double bank_rad, double begin_m, double end_m, double transition_m)
    : slope_{std::tan(bank_rad)}, begin_m_{begin_m}, end_m_{end_m}, transition_m_{transition_m} {}

RoadPoint BankedStretchRoad::at(double x_m, double y_m) const noexcept {
    const Blend entry = smooth_step(x_m, begin_m_, begin_m_ + transition_m_);
    const Blend exit = smooth_step(x_m, end_m_, end_m_ + transition_m_);
    const double slope = slope_ * (entry.value - exit.value);
    return surface(slope * y_m, slope_ * (entry.slope - exit.slope) * y_m, slope);
}

}  // namespace sil
