// Uneven roads: rough ones, one-sided bumps, a bank that begins and ends, a crown.
#pragma once

#include <cstdint>
#include <vector>

#include "sil/world/vehicle/road.hpp"

namespace sil {

struct ProfilePoint {
    double height_m{0.0};
    double slope{0.0};  // of the height along the track
};

// Random heights of one track with the spectrum of ISO 8608: filtered noise in a table, read with a cubic
// interpolation. Power spectral density of the height G(n) = G(n0) (n / n0)^-2 with n0 = 0.1 cycles/m, from
// 0.05 cycles/m (below it even: longer waves lift both sides of a real road together) up to what a tyre's
// contact patch still feels. The geometric mean of class C is G(n0) = 256e-6 m^3. The same seed gives the
// same profile on every machine. Repeats after `length_m`.
class RoughnessProfile {
 public:
    static constexpr double class_c_m3 = 256.0e-6;
    static constexpr double spacing_m = 0.1;
    static constexpr double length_m = 819.2;

    RoughnessProfile(double density_m3, std::uint64_t seed);

    ProfilePoint at(double distance_m) const noexcept;

 private:
    std::vector<double> heights_m_;
};

// A road along the x axis whose left and right wheel tracks are rough without regard to each other, joined by
// a smooth surface of one metre's width. The first 20 m are level; roughness is complete after 40 m.
class TwoTrackRoad final : public Road {
 public:
    TwoTrackRoad(double density_m3, std::uint64_t seed);
    RoadPoint at(double x_m, double y_m) const noexcept override;
    Vector3 mean_normal(double, double) const noexcept override { return Vector3::UnitZ(); }

 private:
    RoughnessProfile left_;
    RoughnessProfile right_;
};

// A plane that is equally rough in every direction, for turns: the sum of corrugations in five directions,
// scaled so that a track along any line has the density asked for. Level within 20 m of the origin, complete
// from 40 m on.
class RoughPlane final : public Road {
 public:
    RoughPlane(double density_m3, std::uint64_t seed);
    RoadPoint at(double x_m, double y_m) const noexcept override;
    Vector3 mean_normal(double, double) const noexcept override { return Vector3::UnitZ(); }

 private:
    struct Corrugation {
        double cosine;
        double sine;
        RoughnessProfile profile;
    };
    std::vector<Corrugation> corrugations_;
};

// Level but for bumps under the left wheels (positive y) that rise and fall as a cosine does.
class OneSidedBumpRoad final : public Road {
 public:
    // Bumps begin at `first_m`, and again every `interval_m`, which is more than `length_m`; `count` of them.
    OneSidedBumpRoad(double height_m, double length_m, double first_m, double interval_m, int count);
    RoadPoint at(double x_m, double y_m) const noexcept override;
    Vector3 mean_normal(double, double) const noexcept override { return Vector3::UnitZ(); }

 private:
    double height_m_;
    double length_m_;
    double first_m_;
    double interval_m_;
    double count_;
};

// A straight road along the x axis, level at first, then banked about that axis (positive: the side of
// positive y is up), then level again; bank changes smoothly over `transition_m` at either end.
class BankedStretchRoad final : public Road {
 public:
    BankedStretchRoad(double bank_rad, double begin_m, double end_m, double transition_m);
    RoadPoint at(double x_m, double y_m) const noexcept override;

 private:
    double slope_;
    double begin_m_;
    double end_m_;
    double transition_m_;
};

// A straight road along the x axis that falls by `slope` to either side of its crown, which is rounded over a
// metre or so, so that water runs off.
class CrownedRoad final : public Road {
 public:
    CrownedRoad(double slope, double crown_y_m);
    RoadPoint at(double x_m, double y_m) const noexcept override;

 private:
    double slope_;
    double crown_y_m_;
};

}  // namespace sil
