// Statistics: Wilson's interval against published values, quantiles against values found by hand.
#include "sil/judge/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

void expect_interval(std::size_t count, std::size_t total, double lowest, double highest) {
    const sil::ConfidenceInterval interval =
        sil::wilson_interval(static_cast<double>(count), static_cast<double>(total));
    EXPECT_NEAR(interval.lowest, lowest, 0.00005) << count << " of " << total;
    EXPECT_NEAR(interval.highest, highest, 0.00005) << count << " of " << total;
}

// R. G. Newcombe, Statistics in Medicine 17 (1998) 857-872, table I, method 3.
TEST(Wilson, GivesTheIntervalsOfNewcombesTable) {
    expect_interval(81U, 263U, 0.2553, 0.3662);
    expect_interval(15U, 148U, 0.0624, 0.1605);
    expect_interval(0U, 20U, 0.0000, 0.1611);
    expect_interval(1U, 29U, 0.0061, 0.1718);
}

TEST(Wilson, IsSymmetricInSuccessAndFailure) {
    const sil::ConfidenceInterval some = sil::wilson_interval(3.0, 40.0);
    const sil::ConfidenceInterval others = sil::wilson_interval(37.0, 40.0);
    EXPECT_NEAR(some.lowest, 1.0 - others.highest, 1.0e-12);
    EXPECT_NEAR(some.highest, 1.0 - others.lowest, 1.0e-12);
}

TEST(Wilson, StaysBetweenNoughtAndOne) {
    for (int total = 1; total <= 200; ++total) {
        EXPECT_GE(sil::wilson_interval(0.0, total).lowest, 0.0) << total;
        EXPECT_LE(sil::wilson_interval(total, total).highest, 1.0) << total;
    }
}

TEST(Share, HasTheIntervalOfAsManyTrialsAsItIsWorth) {
    const auto expect_same = [](const sil::Share& share, double count, double total) {
        EXPECT_EQ(share.confidence().lowest, sil::wilson_interval(count, total).lowest);
        EXPECT_EQ(share.confidence().highest, sil::wilson_interval(count, total).highest);
    };
    expect_same({3U, 40U}, 3.0, 40.0);
    expect_same({1U, 1U}, 1.0, 1.0);
    expect_same({1U, 2U, 1.0}, 0.5, 1.0);
    EXPECT_NEAR(sil::Share({1U, 1U}).confidence().lowest, 0.2065, 0.00005);
    EXPECT_EQ(sil::Share{}.confidence().lowest, 0.0);
    EXPECT_EQ(sil::Share{}.confidence().highest, 1.0);
}

TEST(Wilson, SaysNothingAboutNoRuns) {
    expect_interval(0U, 0U, 0.0, 1.0);
    EXPECT_TRUE(std::isnan(sil::Share{}.value()));
}

// This number of vehicles with ten runs each, of which this number count.
sil::Share of_vehicles(int vehicles, int counting, int offset = 0) {
    sil::ShareByVehicle shares;
    for (int vehicle = 0; vehicle < vehicles; ++vehicle) {
        const int own = counting + (vehicle % 2 == 0 ? offset : -offset);
        for (int run = 0; run < 10; ++run) {
            shares.add(static_cast<std::size_t>(vehicle), run < own);
        }
    }
    return shares.share();
}

TEST(ShareByVehicle, TakesTheRunsOfFewVehiclesForIndependent) {
    const sil::Share nine = of_vehicles(9, 7, 3);
    EXPECT_EQ(nine.total, 90U);
    EXPECT_EQ(nine.independent, 0.0);
    EXPECT_GT(of_vehicles(10, 7, 3).independent, 0.0);
}

TEST(ShareByVehicle, CountsVehiclesThatAreAllOrNothing) {
    // Half of twenty vehicles always, half never: as twenty throws of a coin, less the one that finds the
    // mean.
    const sil::Share share = of_vehicles(20, 5, 5);
    EXPECT_DOUBLE_EQ(share.value(), 0.5);
    EXPECT_NEAR(share.independent, 19.0, 1.0e-9);
    EXPECT_NEAR(share.confidence().lowest, sil::wilson_interval(9.5, 19.0).lowest, 1.0e-12);
}

// One vehicle of a hundred runs always, another never; eight more have a run each.
TEST(ShareByVehicle, OfTwoVehiclesThatOutweighTheOthersIsTwoTrials) {
    sil::ShareByVehicle shares;
    for (int run = 0; run < 100; ++run) {
        shares.add(0U, true);
        shares.add(1U, false);
    }
    for (int vehicle = 0; vehicle < 8; ++vehicle) {
        shares.add(2U + static_cast<std::size_t>(vehicle), vehicle < 4);
    }
    // Residuals of 50 twice and of 1/2 eight times, of 208 runs.
    EXPECT_NEAR(shares.share().independent, 0.25 / (10.0 / 9.0 * 5002.0 / (208.0 * 208.0)), 1.0e-9);
}

TEST(ShareByVehicle, CountsRunsWhereVehiclesAreAlike) {
    EXPECT_EQ(of_vehicles(20, 5).independent, 200.0);
    // By the formula: residuals of 1 in 20 vehicles, so the variance is 20/19 * 20/200^2.
    EXPECT_NEAR(of_vehicles(20, 5, 1).independent, 200.0, 1.0e-9);
    EXPECT_NEAR(of_vehicles(20, 5, 3).independent, 0.25 / (20.0 / 19.0 * 180.0 / 40000.0), 1.0e-9);
}

TEST(ShareByVehicle, OfAllOrNoneThereAreAsManyTrialsAsVehicles) {
    EXPECT_EQ(of_vehicles(20, 10).independent, 20.0);
    EXPECT_EQ(of_vehicles(20, 0).independent, 20.0);
    EXPECT_NEAR(of_vehicles(20, 0).confidence().highest, 0.1611, 0.00005);
}

TEST(Quantile, LiesBetweenTheNeighbours) {
    EXPECT_DOUBLE_EQ(*sil::quantile({4.0, 1.0, 2.0, 3.0}, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(*sil::quantile({10.0, 0.0}, 0.1), 1.0);
    EXPECT_DOUBLE_EQ(*sil::quantile({3.0, 1.0, 2.0}, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(*sil::quantile({3.0, 1.0, 2.0}, 1.0), 3.0);
    EXPECT_DOUBLE_EQ(*sil::quantile({5.0}, 0.1), 5.0);
    EXPECT_FALSE(sil::quantile({}, 0.5).has_value());
}

}  // namespace
