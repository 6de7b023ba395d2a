// Peaks: what of an index counts, and until when.
#include "sil/studies/campaign/peaks.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> times(std::size_t count) {
    std::vector<double> times_s;
    for (std::size_t k = 0U; k < count; ++k) {
        times_s.push_back(0.01 * static_cast<double>(k));
    }
    return times_s;
}

sil::IndexPeaks peaks(const std::vector<double>& levels, std::size_t cycles,
                      const std::optional<double>& lift_time_s = {}) {
    return sil::peaks_of(times(levels.size()), levels, cycles, lift_time_s);
}

TEST(Peaks, OfASingleCycleIsTheLargestLevel) {
    const sil::IndexPeaks found = peaks({0.1, 1.5, 0.3}, 1U);
    EXPECT_EQ(found.whole, 1.5);
    EXPECT_EQ(found.before_100ms, 1.5);
    EXPECT_EQ(found.first_time_s, 0.01);
    EXPECT_EQ(peaks({0.1, 1.5, 0.3}, 0U).whole, 1.5);
}

TEST(Peaks, WhatDoesNotLastDoesNotCount) {
    const sil::IndexPeaks found = peaks({0.1, 1.5, 0.3, 1.2, 1.1, 0.2}, 2U);
    EXPECT_EQ(found.whole, 1.1);
    EXPECT_EQ(found.first_time_s, 0.04);
    EXPECT_EQ(peaks({5.0}, 2U).whole, 0.0);
}

TEST(Peaks, EndWithTwoWheelLiftOff) {
    std::vector<double> levels(30, 0.2);
    levels[4] = 0.7;
    levels[10] = 0.8;
    levels[15] = 0.9;
    levels[16] = 3.0;
    const sil::IndexPeaks found = peaks(levels, 1U, 0.15);
    EXPECT_EQ(found.whole, 0.9);         // at 0.15 s itself
    EXPECT_EQ(found.before_100ms, 0.7);  // up to 0.05 s
    EXPECT_FALSE(found.first_time_s);
}

TEST(Peaks, OneTenthOfASecondBeforeCountsAsEarly) {
    std::vector<double> levels(30, 0.2);
    levels[5] = 1.0;
    EXPECT_EQ(peaks(levels, 1U, 0.15).before_100ms, 1.0);
    EXPECT_EQ(peaks(levels, 1U, 0.149).before_100ms, 0.2);
}

TEST(Peaks, ALevelThatIsNotANumberBreaksTheRow) {
    EXPECT_EQ(peaks({1.2, nan, 1.3, 0.4}, 2U).whole, 0.4);
    EXPECT_EQ(peaks({nan, nan, nan}, 1U).whole, 0.0);
}

}  // namespace
