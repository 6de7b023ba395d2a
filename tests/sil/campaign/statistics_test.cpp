// Statistics: Wilson's interval against published values, quantiles against values found by hand.
#include "sil/studies/campaign/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

void expect_interval(std::size_t count, std::size_t total, double lowest, double highest) {
    const sil::ConfidenceInterval interval = sil::wilson_interval(count, total);
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
    const sil::ConfidenceInterval some = sil::wilson_interval(3U, 40U);
    const sil::ConfidenceInterval others = sil::wilson_interval(37U, 40U);
    EXPECT_NEAR(some.lowest, 1.0 - others.highest, 1.0e-12);
    EXPECT_NEAR(some.highest, 1.0 - others.lowest, 1.0e-12);
}

TEST(Wilson, SaysNothingAboutNoRuns) {
    expect_interval(0U, 0U, 0.0, 1.0);
    EXPECT_TRUE(std::isnan(sil::Share{}.value()));
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
