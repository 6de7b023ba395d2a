// Road: the surface under the wheels, seen point by point.
#pragma once

#include <memory>

#include "sil/world/vehicle/vector.hpp"

namespace sil {

template <typename Real>
struct BasicRoadPoint {
    Real height_m{0.0};
    Vector3Of<Real> normal{Vector3Of<Real>::UnitZ()};  // of length 1, in the earth-fixed frame, pointing up
    Real friction_factor{1.0};                         // multiplies the tyre's friction
    // Distance by which the point lies beyond the face of a kerb along the x axis, > 0 to the left of it and
    // < 0 to the right (0: no kerb), and height of that kerb.
    Real beyond_kerb_m{0.0};
    Real kerb_height_m{0.0};
    // Soft ground piles up beside a wheel that slides sideways: its largest force over the wheel's load.
    Real softness{0.0};
};
using RoadPoint = BasicRoadPoint<double>;

// Implementations must be pure functions of position, so that a run can be repeated.
class Road {
 public:
    Road() = default;
    Road(const Road&) = delete;
    Road& operator=(const Road&) = delete;
    virtual ~Road() = default;

    // The surface above or below the earth-fixed point (x, y).
    virtual RoadPoint at(double x_m, double y_m) const noexcept = 0;

    // Normal of the road without its unevenness: what bank, roll and pitch relative to the road refer to.
    virtual Vector3 mean_normal(double x_m, double y_m) const noexcept { return at(x_m, y_m).normal; }
};

// Level, or inclined sideways about the x axis: the side of positive y is up for a positive bank.
class PlaneRoad final : public Road {
 public:
    explicit PlaneRoad(double bank_rad = 0.0, double friction_factor = 1.0);
    RoadPoint at(double x_m, double y_m) const noexcept override;
    Vector3 mean_normal(double, double) const noexcept override { return point_.normal; }

 private:
    double slope_;
    RoadPoint point_;
};

// A circular track of constant bank about a centre at (0, radius), counter-clockwise; the outer edge is up
// for a positive outer bank. Height is zero on the circle of the given radius, which passes through the
// origin.
class BankedCircleRoad final : public Road {
 public:
    BankedCircleRoad(double radius_m, double outer_bank_rad, double friction_factor = 1.0);
    RoadPoint at(double x_m, double y_m) const noexcept override;

 private:
    double radius_m_;
    double slope_;
    double cosine_;
    double sine_;
    double friction_factor_;
};

// Another road with left and right exchanged.
class MirroredRoad final : public Road {
 public:
    explicit MirroredRoad(std::unique_ptr<const Road> original);
    RoadPoint at(double x_m, double y_m) const noexcept override;
    Vector3 mean_normal(double x_m, double y_m) const noexcept override;

 private:
    std::unique_ptr<const Road> original_;
};

}  // namespace sil
