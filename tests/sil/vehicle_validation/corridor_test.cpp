// Corridor: bounds about a measured signal, and what lies within.
#include <gtest/gtest.h>

#include <cmath>

#include "sil/studies/vehicle_validation/drive_comparison.hpp"

namespace {

using sil::Corridor;
using sil::corridor_about;
using sil::share_within;

TEST(Corridor, IsOffsetAndShareAway) {
    const Corridor corridor = corridor_about({0.0, 2.0, -4.0}, 0.01, {0.5, 0.1, 0.0});
    EXPECT_DOUBLE_EQ(corridor.lower[0], -0.5);
    EXPECT_DOUBLE_EQ(corridor.upper[0], 0.5);
    EXPECT_DOUBLE_EQ(corridor.lower[1], 1.3);
    EXPECT_DOUBLE_EQ(corridor.upper[1], 2.7);
    EXPECT_DOUBLE_EQ(corridor.lower[2], -4.9);
    EXPECT_DOUBLE_EQ(corridor.upper[2], -3.1);
}

TEST(Corridor, TakesTheExtremesOfItsTime) {
    const Corridor corridor = corridor_about({0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 0.01, {0.1, 0.0, 0.02});
    EXPECT_DOUBLE_EQ(corridor.upper[0], 1.1);
    EXPECT_DOUBLE_EQ(corridor.upper[4], 1.1);
    EXPECT_DOUBLE_EQ(corridor.upper[5], 0.1);
    for (const double lower : corridor.lower) {
        EXPECT_DOUBLE_EQ(lower, -0.1);
    }
}

TEST(Corridor, CountsWhatLiesWithin) {
    const Corridor corridor = corridor_about({1.0, 1.0, 1.0, 1.0}, 0.01, {0.1, 0.0, 0.0});
    EXPECT_DOUBLE_EQ(share_within(corridor, {1.0, 1.09, 1.11, 0.89}, {true, true, true, true}), 0.5);
    EXPECT_DOUBLE_EQ(share_within(corridor, {1.0, 1.09, 1.11, 0.89}, {true, false, true, false}), 0.5);
    EXPECT_DOUBLE_EQ(share_within(corridor, {std::nan(""), 1.0, 1.0, 1.0}, {true, true, true, true}), 0.75);
    EXPECT_TRUE(std::isnan(share_within(corridor, {1.0, 1.0, 1.0, 1.0}, {false, false, false, false})));
}

}  // namespace
