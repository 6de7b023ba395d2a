// Uneven roads: their normals fit their heights, their roughness is what ISO 8608 says, and nothing changes
// from run to run.
#include <gtest/gtest.h>
#include <cmath>
#include <complex>
#include <memory>
#include <vector>

#include "sil/world/vehicle/uneven_road.hpp"

namespace {

constexpr double pi = 3.14159265358979323846;

// One-sided density of the height at `cycles` per length of the profile, averaged over `width` neighbours.
double density_m3(const std::vector<double>& heights, double spacing_m, int cycles, int width) {
    const double count = static_cast<double>(heights.size());
    double sum = 0.0;
    for (int k = cycles; k < cycles + width; ++k) {
        std::complex<double> amplitude{};
        for (std::size_t i = 0; i < heights.size(); ++i) {
            amplitude += heights[i] * std::polar(1.0, -2.0 * pi * k * static_cast<double>(i) / count);
        }
        sum += 2.0 * std::norm(amplitude) * spacing_m / count;
    }
    return sum / width;
}

void expect_normals_fit_heights(const sil::Road& road) {
    constexpr double h = 1e-5;
    for (double x = -3.0; x < 130.0; x += 0.737) {
        for (double y = -2.3; y < 2.4; y += 0.41) {
            const sil::RoadPoint point = road.at(x, y);
            const double slope_x = (road.at(x + h, y).height_m - road.at(x - h, y).height_m) / (2.0 * h);
            const double slope_y = (road.at(x, y + h).height_m - road.at(x, y - h).height_m) / (2.0 * h);
            ASSERT_NEAR(point.normal.norm(), 1.0, 1e-12);
            ASSERT_NEAR(-point.normal.x() / point.normal.z(), slope_x, 1e-4) << x << " " << y;
            ASSERT_NEAR(-point.normal.y() / point.normal.z(), slope_y, 1e-4) << x << " " << y;
        }
    }
}

TEST(UnevenRoad, NormalsAreSquareToTheSurfaceEverywhere) {
    expect_normals_fit_heights(sil::TwoTrackRoad{256e-6, 1U});
    expect_normals_fit_heights(sil::RoughPlane{256e-6, 1U});
    expect_normals_fit_heights(sil::OneSidedBumpRoad{0.05, 3.0, 20.0, 25.0, 3});
    expect_normals_fit_heights(sil::BankedStretchRoad{0.1, 20.0, 80.0, 15.0});
    expect_normals_fit_heights(sil::CrownedRoad{0.04, 1.75});
    expect_normals_fit_heights(sil::MirroredRoad{std::make_unique<sil::TwoTrackRoad>(256e-6, 1U)});
}

TEST(RoughnessProfile, HasTheDensityOfItsClassFallingWithTheSquareOfTheWaveNumber) {
    const sil::RoughnessProfile profile{sil::RoughnessProfile::class_c_m3, 7U};
    std::vector<double> heights;
    for (int i = 0; i < 2048; ++i) {  // a quarter of the profile's points, four of them apart
        heights.push_back(profile.at(0.4 * i).height_m);
    }
    for (const double wave_number_pm : {0.12, 0.25, 0.5}) {
        const int cycles = static_cast<int>(wave_number_pm * sil::RoughnessProfile::length_m);
        const double expected = 256e-6 * std::pow(0.1 / wave_number_pm, 2.0);
        const double found = density_m3(heights, 0.4, cycles - 20, 40);
        EXPECT_GT(found, 0.6 * expected) << wave_number_pm;
        EXPECT_LT(found, 1.6 * expected) << wave_number_pm;
    }
}

TEST(RoughnessProfile, IsTheSameForTheSameSeedAndAnotherForAnother) {
    const sil::RoughnessProfile one{256e-6, 3U};
    const sil::RoughnessProfile same{256e-6, 3U};
    const sil::RoughnessProfile other{256e-6, 4U};
    double product = 0.0;
    double square = 0.0;
    for (double x = 0.0; x < 800.0; x += 0.5) {
        ASSERT_EQ(one.at(x).height_m, same.at(x).height_m);
        product += one.at(x).height_m * other.at(x).height_m;
        square += one.at(x).height_m * one.at(x).height_m;
    }
    EXPECT_LT(std::abs(product), 0.15 * square);
}

TEST(RoughnessProfile, RepeatsWithoutAStep) {
    const sil::RoughnessProfile profile{256e-6, 3U};
    const double end = sil::RoughnessProfile::length_m;
    for (double x = -1.0; x < 1.0; x += 0.01) {
        ASSERT_NEAR(profile.at(x).height_m, profile.at(x + end).height_m, 1e-9);
        ASSERT_NEAR(profile.at(x).height_m, profile.at(x + 0.001).height_m, 1e-3);
    }
}

TEST(TwoTrackRoad, LeftAndRightTracksHaveNothingToDoWithEachOther) {
    const sil::TwoTrackRoad road{256e-6, 11U};
    double left_right = 0.0;
    double left = 0.0;
    double right = 0.0;
    for (double x = 40.0; x < 840.0; x += 0.2) {
        const double l = road.at(x, 0.8).height_m;
        const double r = road.at(x, -0.8).height_m;
        left_right += l * r;
        left += l * l;
        right += r * r;
        ASSERT_EQ(road.at(x, 0.7).height_m, l);
    }
    EXPECT_LT(std::abs(left_right) / std::sqrt(left * right), 0.15);
    EXPECT_EQ(road.at(19.0, 0.8).height_m, 0.0);
}

TEST(RoughPlane, IsEquallyRoughAlongAnyLine) {
    // The mean square of what is left of a track after taking out waves longer than some metres.
    const sil::RoughPlane plane{256e-6, 5U};
    const auto short_waves = [](const auto& height) {
        double sum = 0.0;
        for (int i = 0; i < 4000; ++i) {
            const double s = 60.0 + 0.15 * i;
            const double middle = height(s);
            const double ends = 0.5 * (height(s - 1.0) + height(s + 1.0));
            sum += (middle - ends) * (middle - ends);
        }
        return std::sqrt(sum / 4000.0);
    };
    const sil::RoughnessProfile profile{256e-6, 99U};
    const double one_track = short_waves([&](double s) { return profile.at(s).height_m; });
    for (const double angle : {0.0, 0.4, 0.9, 1.3, 2.2}) {
        const double found = short_waves(
            [&](double s) { return plane.at(s * std::cos(angle), s * std::sin(angle)).height_m; });
        EXPECT_NEAR(found / one_track, 1.0, 0.25) << angle;
    }
}

TEST(UnevenRoad, BankAndRollReferToTheRoadWithoutItsUnevenness) {
    const sil::TwoTrackRoad rough{256e-6, 11U};
    EXPECT_EQ(rough.mean_normal(60.0, 0.1), sil::Vector3::UnitZ());
    const sil::BankedStretchRoad banked{0.1, 20.0, 80.0, 15.0};
    EXPECT_NEAR(banked.mean_normal(60.0, 0.0).y(), -std::sin(0.1), 1e-12);
    EXPECT_EQ(banked.mean_normal(10.0, 0.0), sil::Vector3::UnitZ());
    EXPECT_EQ(banked.mean_normal(96.0, 0.0), sil::Vector3::UnitZ());
    const sil::MirroredRoad mirrored{std::make_unique<sil::BankedStretchRoad>(0.1, 20.0, 80.0, 15.0)};
    EXPECT_NEAR(mirrored.mean_normal(60.0, 0.0).y(), std::sin(0.1), 1e-12);
}

TEST(OneSidedBumpRoad, HasItsBumpsOnTheLeftOnlyAndAsHighAsAsked) {
    const sil::OneSidedBumpRoad road{0.05, 3.0, 20.0, 25.0, 3};
    for (const double crest : {21.5, 46.5, 71.5}) {
        EXPECT_NEAR(road.at(crest, 0.8).height_m, 0.05, 1e-12);
        EXPECT_EQ(road.at(crest, -0.8).height_m, 0.0);
    }
    EXPECT_EQ(road.at(96.5, 0.8).height_m, 0.0);
    EXPECT_EQ(road.at(-3.5, 0.8).height_m, 0.0);
    EXPECT_EQ(road.at(30.0, 0.8).height_m, 0.0);
}

TEST(CrownedRoad, FallsToEitherSideOfItsCrown) {
    const sil::CrownedRoad road{0.04, 1.75};
    EXPECT_EQ(road.at(7.0, 1.75).height_m, 0.0);
    for (const double away : {2.0, 4.0}) {
        EXPECT_EQ(road.at(7.0, 1.75 + away).height_m, road.at(9.0, 1.75 - away).height_m);
    }
    EXPECT_NEAR(road.at(0.0, 6.75).height_m - road.at(0.0, 5.75).height_m, -0.04, 0.001);
    EXPECT_LT(road.mean_normal(0.0, -0.05).y(), -0.035) << "to the right of the crown the left side is up";
    EXPECT_GT(road.mean_normal(0.0, 3.55).y(), 0.035);
}

}  // namespace
