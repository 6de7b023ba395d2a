// Uneven roads: heights and their slopes.
#include "sil/world/vehicle/uneven_road.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sil/random.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double reference_pm = 0.1;       // n0
constexpr double lowest_pm = 0.05;         // cycles per metre
constexpr std::size_t point_count = 8192;  // a power of two, so that a mask wraps
constexpr std::size_t mask = point_count - 1U;
static_assert(point_count * RoughnessProfile::spacing_m == RoughnessProfile::length_m);

class Random {
 public:
    explicit Random(std::uint64_t seed) : state_{seed} {}

    // Mean 0, variance 1; the sum of twelve uniform numbers is close enough to a normal one.
    double normal() {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i) {
            sum += unit_interval(next());
        }
        return sum;
    }

 private:
    std::uint64_t next() {
        const std::uint64_t bits = scrambled(state_);
        state_ += scrambled_step;
        return bits;
    }
    std::uint64_t state_;
};

// Weights 1/4, 1/2, 1/4: the contact patch does not feel what is shorter than itself.
std::vector<double> smoothed(const std::vector<double>& values) {
    std::vector<double> result(point_count);
    for (std::size_t i = 0; i < point_count; ++i) {
        result[i] = 0.5 * values[i] + 0.25 * (values[(i - 1U) & mask] + values[(i + 1U) & mask]);
    }
    return result;
}

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

RoughnessProfile::RoughnessProfile(double density_m3, std::uint64_t seed) : heights_m_(point_count) {
    Random random{seed};
    std::vector<double> noise(point_count);
    for (double& value : noise) {
        value = random.normal();
    }
    // A slope of white noise has the density (2 pi n0)^2 G(n0) at every n; its samples' variance is that
    // times the bandwidth 1 / (2 spacing).
    const double slope = 2.0 * pi * reference_pm * std::sqrt(density_m3 / (2.0 * spacing_m));
    const double decay = std::exp(-2.0 * pi * lowest_pm * spacing_m);
    double height = 0.0;
    for (int lap = 0; lap < 2; ++lap) {  // the second begins as it will end: the profile repeats smoothly
        for (std::size_t i = 0; i < point_count; ++i) {
            height = decay * height + spacing_m * slope * noise[i];
            heights_m_[i] = height;
        }
    }
    heights_m_ = smoothed(heights_m_);
}

ProfilePoint RoughnessProfile::at(double distance_m) const noexcept {
    const double position = distance_m * (1.0 / spacing_m);
    const double whole = std::floor(position);
    const double t = position - whole;
    const auto index = static_cast<std::size_t>(static_cast<std::int64_t>(whole));
    const double before = heights_m_[(index - 1U) & mask];
    const double left = heights_m_[index & mask];
    const double right = heights_m_[(index + 1U) & mask];
    const double after = heights_m_[(index + 2U) & mask];
    const double a = 0.5 * (after - before) + 1.5 * (left - right);
    const double b = before - 2.5 * left + 2.0 * right - 0.5 * after;
    const double c = 0.5 * (right - before);
    return {left + t * (c + t * (b + t * a)), (c + t * (2.0 * b + t * 3.0 * a)) * (1.0 / spacing_m)};
}

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

CrownedRoad::CrownedRoad(double slope, double crown_y_m) : slope_{slope}, crown_y_m_{crown_y_m} {}

// A hyperbola: level at the crown, as steep as asked for beyond the half joint.
RoadPoint CrownedRoad::at(double /*x_m*/, double y_m) const noexcept {
    const double from_crown = y_m - crown_y_m_;
    const double rounded = std::sqrt(from_crown * from_crown + half_joint_m * half_joint_m);
    return surface(slope_ * (half_joint_m - rounded), 0.0, -slope_ * from_crown / rounded);
}

}  // namespace sil
